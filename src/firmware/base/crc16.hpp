// CRC-16 of SDO block transfer (CiA 301, 7.2.4.3.16: polynomial 1021h, start 0, not reflected, no final XOR;
// "123456789" gives 31C3h).
#pragma once

#include <array>

#include "firmware/base/bytes.hpp"

namespace canproof {

class Crc16 {
  public:
    constexpr void add(const ByteView bytes) noexcept {
        std::uint32_t crc{register_};
        const std::uint8_t* const data = bytes.data();
        const std::size_t even = bytes.size() & ~std::size_t{1U};
        for (std::size_t i = 0U; i < even; i += 2U) {
            const std::uint32_t two = crc ^ ((std::uint32_t{data[i]} << 8U) | data[i + 1U]);
            crc = std::uint32_t{first_of_two[two >> 8U]} ^ last[two & 0xFFU];
        }
        if (even != bytes.size()) {
            crc = ((crc << 8U) & 0xFFFFU) ^ last[(crc >> 8U) ^ data[even]];
        }
        register_ = static_cast<std::uint16_t>(crc);
    }
    constexpr std::uint16_t value() const noexcept { return register_; }

  private:
    using Table = std::array<std::uint16_t, 256U>;

    /// Remainder of every byte followed by `zeros` zero bits: a look-up a byte in place of eight steps.
    static constexpr Table remainders(const std::uint32_t zeros) noexcept {
        Table rows{};
        for (std::uint32_t byte = 0U; byte < rows.size(); ++byte) {
            std::uint32_t remainder = byte << 8U;
            for (std::uint32_t bit = 8U; bit < zeros; ++bit) {
                const bool carry = (remainder & 0x8000U) != 0U;
                remainder = ((remainder << 1U) & 0xFFFFU) ^ (carry ? 0x1021U : 0U);
            }
            rows[byte] = static_cast<std::uint16_t>(remainder);
        }
        return rows;
    }
    static const Table last;          ///< a byte that nothing follows: sixteen zero bits make room for the remainder
    static const Table first_of_two;  ///< a byte that another one follows

    std::uint16_t register_{0U};
};

inline constexpr Crc16::Table Crc16::last = Crc16::remainders(16U);
inline constexpr Crc16::Table Crc16::first_of_two = Crc16::remainders(24U);

}  // namespace canproof
