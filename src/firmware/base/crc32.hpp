// SPDX-License-Identifier: Apache-2.0
// CRC-32 (ISO-HDLC: reflected polynomial EDB88320h, start and final XOR FFFFFFFFh; "123456789" gives CBF43926h).
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof {

class Crc32 {
  public:
    /// The result of value() over any bytes followed by their own CRC, least significant byte first.
    static constexpr std::uint32_t residue = 0x2144DF1CU;

    constexpr void add(const ByteView bytes) noexcept {
        for (std::size_t i = 0U; i < bytes.size(); ++i) {
            register_ ^= bytes[i];
            for (std::uint32_t bit = 0U; bit < 8U; ++bit) {
                const bool carry = (register_ & 1U) != 0U;
                register_ = (register_ >> 1U) ^ (carry ? 0xEDB88320U : 0U);
            }
        }
    }
    constexpr std::uint32_t value() const noexcept { return register_ ^ 0xFFFFFFFFU; }

  private:
    std::uint32_t register_{0xFFFFFFFFU};
};

}  // namespace canproof
