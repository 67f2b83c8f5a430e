// SPDX-License-Identifier: Apache-2.0
// CRC-16 of SDO block transfer (CiA 301, 7.2.4.3.16: polynomial 1021h, start 0, not reflected, no final XOR;
// "123456789" gives 31C3h).
#pragma once

#include <array>

#include "firmware/base/bytes.hpp"

namespace canproof {

class Crc16 {
  public:
    constexpr void add(const ByteView bytes) noexcept {
        for (std::size_t i = 0U; i < bytes.size(); ++i) {
            swapped_ = after_one(swapped_, bytes[i]);
        }
    }
    /// Adds the low seven bytes of `segment`, least significant first: the data of one segment of a block transfer.
    /// Inlining is forced: the limit on block upload leaves no time for a call per segment
    /// (tests/bench/transactions.cpp).
    [[gnu::always_inline]] constexpr void add_seven(const std::uint64_t segment) noexcept {
        swapped_ = after_one(after_two(after_two(after_two(swapped_, segment), segment >> 16U), segment >> 32U),
                             segment >> 48U);
    }
    constexpr std::uint16_t value() const noexcept { return swapped(swapped_); }

  private:
    using Table = std::array<std::uint16_t, 256U>;

    static constexpr std::uint16_t swapped(const std::uint32_t word) noexcept {
        return static_cast<std::uint16_t>(((word >> 8U) | (word << 8U)) & 0xFFFFU);
    }
    static constexpr std::uint32_t after_two(const std::uint32_t swapped, const std::uint64_t bytes) noexcept {
        const auto two = static_cast<std::uint32_t>((swapped ^ bytes) & 0xFFFFU);
        return std::uint32_t{first_of_two[two & 0xFFU]} ^ last[two >> 8U];
    }
    static constexpr std::uint32_t after_one(const std::uint32_t swapped, const std::uint64_t bytes) noexcept {
        return (swapped >> 8U) ^ last[(swapped ^ bytes) & 0xFFU];
    }

    /// Returns the remainder of every byte followed by `zeros` zero bits, with its bytes swapped. One look-up per byte
    /// replaces eight shifts.
    static constexpr Table remainders(const std::uint32_t zeros) noexcept {
        Table rows{};
        for (std::uint32_t byte = 0U; byte < rows.size(); ++byte) {
            std::uint32_t remainder = byte << 8U;
            for (std::uint32_t bit = 8U; bit < zeros; ++bit) {
                const bool carry = (remainder & 0x8000U) != 0U;
                remainder = ((remainder << 1U) & 0xFFFFU) ^ (carry ? 0x1021U : 0U);
            }
            rows[byte] = swapped(remainder);
        }
        return rows;
    }
    static const Table last;  ///< for a byte with none behind it: sixteen zero bits are shifted in for the remainder
    static const Table first_of_two;  ///< for the first of two bytes that are added in one step

    std::uint32_t swapped_{0U};  ///< the CRC register with its bytes swapped, so that data can be used in memory order
};

inline constexpr Crc16::Table Crc16::last = Crc16::remainders(16U);
inline constexpr Crc16::Table Crc16::first_of_two = Crc16::remainders(24U);

}  // namespace canproof
