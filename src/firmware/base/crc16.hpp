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
        for (std::size_t i = 0U; i < bytes.size(); ++i) {
            const std::uint32_t row = (crc >> 8U) ^ bytes[i];
            crc = ((crc << 8U) & 0xFFFFU) ^ table[row];
        }
        register_ = static_cast<std::uint16_t>(crc);
    }
    constexpr std::uint16_t value() const noexcept { return register_; }

  private:
    static constexpr std::size_t table_size = 256U;

    /// Remainder of every byte followed by sixteen zero bits: one look-up a byte instead of eight steps.
    static constexpr std::array<std::uint16_t, table_size> make_table() noexcept {
        std::array<std::uint16_t, table_size> rows{};
        for (std::uint32_t byte = 0U; byte < table_size; ++byte) {
            std::uint32_t remainder = byte << 8U;
            for (std::uint32_t bit = 0U; bit < 8U; ++bit) {
                const bool carry = (remainder & 0x8000U) != 0U;
                remainder = ((remainder << 1U) & 0xFFFFU) ^ (carry ? 0x1021U : 0U);
            }
            rows[byte] = static_cast<std::uint16_t>(remainder);
        }
        return rows;
    }
    static const std::array<std::uint16_t, table_size> table;

    std::uint16_t register_{0U};
};

inline constexpr std::array<std::uint16_t, Crc16::table_size> Crc16::table = Crc16::make_table();

}  // namespace canproof
