// SPDX-License-Identifier: Apache-2.0
// The CRC-32 of ISO-HDLC for models that compute it often. It takes eight bytes at a time. Its tables come from the
// definition, one bit at a time.
#pragma once

#include <cstddef>
#include <cstdint>

namespace canproof {

/// The tables of QuickCrc32. Table n has the register after a byte and n bytes 00h, for each value of the byte.
class CrcTables {
  public:
    static constexpr std::size_t count = 8;

    constexpr CrcTables() {
        for (std::uint32_t byte = 0; byte < 256; ++byte) {
            std::uint32_t crc = byte;
            for (auto& row : rows_) {
                for (int bit = 0; bit < 8; ++bit) {
                    crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
                }
                row[byte] = crc;
            }
        }
    }
    constexpr std::uint32_t at(std::size_t table, std::uint32_t value) const { return rows_[table][value & 0xFFU]; }

  private:
    std::uint32_t rows_[count][256]{};
};

inline constexpr CrcTables crc_tables{};

class QuickCrc32 {
  public:
    constexpr void add(const std::uint8_t* bytes, std::size_t count) {
        constexpr std::size_t step = CrcTables::count;
        for (; count >= step; count -= step, bytes += step) {
            std::uint32_t next = 0;
            for (std::size_t i = 0; i < step; ++i) {
                const std::uint32_t before = i < sizeof register_ ? register_ >> (8 * i) : 0U;
                next ^= crc_tables.at(step - 1 - i, before ^ bytes[i]);
            }
            register_ = next;
        }
        for (std::size_t i = 0; i < count; ++i) {
            register_ = (register_ >> 8U) ^ crc_tables.at(0, register_ ^ bytes[i]);
        }
    }
    constexpr std::uint32_t value() const { return ~register_; }

  private:
    std::uint32_t register_{0xFFFFFFFF};
};

/// Returns the CRC-32 of "123456789", which is CBF43926h.
constexpr std::uint32_t crc32_of_digits() {
    constexpr std::uint8_t digits[]{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    QuickCrc32 crc;
    crc.add(digits, sizeof digits);
    return crc.value();
}
static_assert(crc32_of_digits() == 0xCBF43926);

}  // namespace canproof
