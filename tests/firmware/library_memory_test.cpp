// SPDX-License-Identifier: Apache-2.0
// Tests the functions of the C library that copy and fill memory, for each alignment. On the microcontroller newlib has
// them.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>

#include "tests/support/library_tests.hpp"

namespace canproof::test::library_memory {
namespace {

constexpr std::size_t longest = 70U;  // more than two of the 16-byte and 64-byte steps in which a library may copy
using Room = std::array<std::uint8_t, 160>;
alignas(8) Room source;
alignas(8) Room target;

/// Fills the room with 1, 2, 3...
void count_up(Room& room) {
    std::iota(room.begin(), room.end(), std::uint8_t{1});
}

/// Returns whether `room` has the bytes first, first + 1, ... at `at`, and the byte 0 everywhere else.
bool has_only(const Room& room, const std::size_t at, const std::size_t length, const std::size_t first) {
    Room expected{};
    std::iota(expected.begin() + static_cast<std::ptrdiff_t>(at),
              expected.begin() + static_cast<std::ptrdiff_t>(at + length), static_cast<std::uint8_t>(first));
    return room == expected;
}

}  // namespace

TEST(LibraryMemory, MemcpyCopiesFromAnyToAnyAlignment) {
    shows_library_rule();
    const auto copy = hidden(&std::memcpy);
    count_up(source);
    for (std::size_t from = 0U; from < 8U; ++from) {
        for (std::size_t to = 0U; to < 8U; ++to) {
            for (std::size_t length = 0U; length <= longest; ++length) {
                target.fill(0U);
                ASSERT_EQ(copy(&target[to], &source[from], length), &target[to]);
                ASSERT_TRUE(has_only(target, to, length, from + 1U)) << from << ' ' << to << ' ' << length;
            }
        }
    }
}

TEST(LibraryMemory, MemmoveCopiesBetweenPlacesThatOverlap) {
    shows_library_rule();
    const auto move = hidden(&std::memmove);
    Room numbers{};
    count_up(numbers);
    for (std::size_t from = 0U; from < 24U; ++from) {
        for (std::size_t to = 0U; to < 24U; ++to) {
            for (const std::size_t length : {0U, 1U, 2U, 3U, 4U, 7U, 15U, 16U, 17U, 20U, 32U, 37U, 70U}) {
                target = numbers;
                ASSERT_EQ(move(&target[to], &target[from], length), &target[to]);
                Room expected = numbers;
                for (std::size_t at = 0U; at < length; ++at) {
                    expected[to + at] = static_cast<std::uint8_t>(from + at + 1U);
                }
                ASSERT_EQ(target, expected) << from << ' ' << to << ' ' << length;
            }
        }
    }
}

TEST(LibraryMemory, MemsetFillsFromAnyAlignment) {
    shows_library_rule();
    const auto fill = hidden(&std::memset);
    for (std::size_t at = 0U; at < 8U; ++at) {
        for (std::size_t length = 0U; length <= longest; ++length) {
            target.fill(0x11U);
            ASSERT_EQ(fill(&target[at], 0x1A5, length), &target[at]);  // the low byte fills: A5h
            Room expected{};
            expected.fill(0x11U);
            for (std::size_t place = at; place < at + length; ++place) {
                expected[place] = 0xA5U;
            }
            ASSERT_EQ(target, expected) << at << ' ' << length;
        }
    }
}

}  // namespace canproof::test::library_memory
