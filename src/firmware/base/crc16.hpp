// SPDX-License-Identifier: Apache-2.0
// CRC-16 of SDO block transfer (CiA 301, 7.2.4.3.16: polynomial 1021h, start 0, not reflected, no final XOR;
// "123456789" gives 31C3h).
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof {

class Crc16 {
  public:
    constexpr void add(const ByteView bytes) noexcept {
        for (std::size_t i = 0U; i < bytes.size(); ++i) {
            remainder_ = ((remainder_ << 8U) & 0xFFFFU) ^ remainder_of((remainder_ >> 8U) ^ bytes[i]);
        }
    }
    /// Adds the upper seven bytes of `frame`, least significant first: the data of a segment of a block transfer,
    /// behind its sequence number. Inlining is forced: the limit of instructions for a block upload
    /// (tests/bench/transactions.cpp) leaves no room for a call per segment.
    [[gnu::always_inline]] constexpr void add_segment(const std::uint64_t frame) noexcept {
        constexpr std::uint64_t seven_bytes = 0x00FFFFFFFFFFFFFFU;
        remainder_ = remainder_of((reversed(frame) & seven_bytes) ^ (std::uint64_t{remainder_} << 40U));
    }
    constexpr std::uint16_t value() const noexcept { return static_cast<std::uint16_t>(remainder_); }

  private:
    /// Returns the eight bytes in reverse order, because a polynomial has its first byte in the highest bits.
    static constexpr std::uint64_t reversed(const std::uint64_t bytes) noexcept {
        return ((bytes & 0xFFU) << 56U) | ((bytes & 0xFF00U) << 40U) | ((bytes & 0xFF0000U) << 24U) |
               ((bytes & 0xFF000000U) << 8U) | ((bytes >> 8U) & 0xFF000000U) | ((bytes >> 24U) & 0xFF0000U) |
               ((bytes >> 40U) & 0xFF00U) | (bytes >> 56U);
    }
    /// Returns the remainder of message * x^16 divided by P = x^16 + x^12 + x^5 + 1, without a table. The quotient is
    /// the whole part of message / (1 + f) with f = x^-4 + x^-11 + x^-16. In GF(2) 1 / (1 + f) is (1 + f)(1 + f^2)(1 +
    /// f^4)(1 + f^8)..., and a square doubles each exponent. A shift by 64 bits or more gives zero, so all factors from
    /// 1 + f^16 on change nothing. Each product is computed in nested form: a(1 + f) = a + ax^-4 + ax^-11 + ax^-16 is
    /// a + (a + (a + ax^-5)x^-7)x^-4. The low 16 bits of quotient * P are the remainder, because the low 16 bits of
    /// message * x^16 are zero.
    static constexpr std::uint32_t remainder_of(const std::uint64_t message) noexcept {
        std::uint64_t quotient = message ^ ((message ^ ((message ^ (message >> 5U)) >> 7U)) >> 4U);
        quotient ^= (quotient ^ ((quotient ^ (quotient >> 10U)) >> 14U)) >> 8U;
        quotient ^= (quotient ^ (quotient >> 28U)) >> 16U;
        const auto low = static_cast<std::uint32_t>((quotient ^ (quotient >> 32U)) & 0xFFFFFFFFU);
        return (low ^ ((low ^ (low << 7U)) << 5U)) & 0xFFFFU;
    }

    std::uint32_t remainder_{0U};
};

}  // namespace canproof
