// SPDX-License-Identifier: Apache-2.0
// The CRC that the floor (floor.hpp) computes: CRC-16 of CiA 301, two bytes at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::bench {

class FloorCrc {
  public:
    FloorCrc() {
        for (std::uint32_t byte = 0; byte < last_byte_.size(); ++byte) {
            std::uint32_t remainder = byte << 8U;
            for (int bit = 0; bit < 16; ++bit) {
                remainder = (remainder << 1U) ^ ((remainder & 0x8000U) != 0 ? 0x1021U : 0U);
                if (bit == 7) {
                    last_byte_[byte] = swapped(remainder);
                }
            }
            first_byte_[byte] = swapped(remainder);
        }
    }

    void start() { crc_ = 0; }
    void add(std::uint64_t data, std::size_t count) {
        for (; count != 0; --count, data >>= 8U) {
            crc_ = after_one(crc_, data);
        }
    }
    void add_seven(std::uint64_t data) {
        crc_ = after_one(after_two(after_two(after_two(crc_, data), data >> 16U), data >> 32U), data >> 48U);
    }
    std::uint16_t value() const { return swapped(crc_); }

  private:
    // crc_ contains the CRC with its two bytes swapped, so that the table lookup can use the data bytes in their own
    // order.
    static std::uint16_t swapped(std::uint32_t word) {
        return static_cast<std::uint16_t>(((word & 0xFFU) << 8U) | ((word >> 8U) & 0xFFU));
    }
    std::uint32_t after_one(std::uint32_t crc, std::uint64_t data) const {
        return (crc >> 8U) ^ last_byte_[(crc ^ data) & 0xFFU];
    }
    std::uint32_t after_two(std::uint32_t crc, std::uint64_t data) const {
        const auto two = static_cast<std::uint16_t>(crc ^ data);
        return static_cast<std::uint32_t>(first_byte_[two & 0xFFU] ^ last_byte_[two >> 8U]);
    }

    std::array<std::uint16_t, 256> first_byte_{};  ///< contributions of the first byte of a pair to the CRC
    std::array<std::uint16_t, 256> last_byte_{};
    std::uint32_t crc_{0};
};

}  // namespace canproof::bench
