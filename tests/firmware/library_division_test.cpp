// SPDX-License-Identifier: Apache-2.0
// Tests the division of 64-bit integers. On the microcontroller the compiler's library computes it (libgcc).
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "tests/support/library_tests.hpp"

namespace canproof::test::library_division {
namespace {

/// Returns numbers of 64 bits whose first bit is 1 and whose 16-bit quarters are 0, 1, 7FFFh, 8000h, 8001h or FFFFh.
/// The library shifts a divisor until its first bit is 1, and divides by its first quarter. With these quarters, its
/// estimate of a quotient is right, or too large by 1 or 2.
std::vector<std::uint64_t> edge_numbers() {
    constexpr std::array<std::uint64_t, 6> quarters{{0U, 1U, 0x7FFFU, 0x8000U, 0x8001U, 0xFFFFU}};
    std::vector<std::uint64_t> numbers{0x8000U, 0x8001U, 0xFFFFU};
    for (int quarter = 2; quarter <= 4; ++quarter) {
        std::vector<std::uint64_t> longer;
        for (const std::uint64_t number : numbers) {
            for (const std::uint64_t next : quarters) {
                longer.push_back((number << 16U) | next);
            }
        }
        numbers = longer;
    }
    return numbers;
}

/// Divides quotient * divisor + remainder by the divisor. Returns whether the division gives this quotient and
/// remainder.
bool divides(const std::uint64_t quotient, const std::uint64_t divisor, const std::uint64_t remainder) {
    const std::uint64_t dividend = hidden((quotient * divisor) + remainder);
    const std::uint64_t by = hidden(divisor);
    return ((dividend / by) == quotient) && ((dividend % by) == remainder);
}

/// Divides for pairs of an edge number of `divisor_bits` and a quotient, with the least and the greatest remainder.
/// Leaves out pairs with a dividend of more than 64 bits.
void check_divisions(const unsigned divisor_bits) {
    const std::vector<std::uint64_t> numbers = edge_numbers();
    for (std::size_t first = 0U; first < numbers.size(); first += 5U) {
        const std::uint64_t divisor = numbers[first] >> (64U - divisor_bits);
        for (std::size_t second = first % 7U; second < numbers.size(); second += 7U) {
            const std::uint64_t quotient = numbers[second] >> (divisor_bits - 1U);
            std::uint64_t beyond{};
            if (!__builtin_mul_overflow(quotient + 1U, divisor, &beyond)) {
                ASSERT_TRUE(divides(quotient, divisor, 0U)) << quotient << ' ' << divisor;
                ASSERT_TRUE(divides(quotient, divisor, divisor - 1U)) << quotient << ' ' << divisor;
            }
            ASSERT_TRUE(divides(quotient >> 1U, divisor, divisor - 1U)) << (quotient >> 1U) << ' ' << divisor;
        }
    }
}

}  // namespace

TEST(LibraryDivision, QuotientAndRemainderOfDivisorsOfAnyLength) {
    shows_library_rule();
    for (unsigned bits = 1U; bits <= 64U; ++bits) {
        check_divisions(bits);
    }
}

TEST(LibraryDivision, QuotientIsOneWhenTheDividendIsLessThanTwiceTheDivisor) {
    shows_library_rule();
    for (const std::uint64_t divisor : edge_numbers()) {
        ASSERT_TRUE(divides(1U, divisor, 0U)) << divisor;
        ASSERT_TRUE(divides(1U, divisor, UINT64_MAX - divisor)) << divisor;
    }
}

TEST(LibraryDivision, QuotientAndRemainderOfTheLargestDividend) {
    shows_library_rule();
    const std::uint64_t largest = hidden(UINT64_MAX);  // 3 * 5 * 17 * 257 * 641 * 65537 * 6700417
    EXPECT_EQ(largest / hidden(std::uint64_t{1}), UINT64_MAX);
    EXPECT_EQ(largest / hidden(std::uint64_t{6700417}), 2753074036095U);  // 3 * 5 * 17 * 257 * 641 * 65537
    EXPECT_EQ(largest % hidden(std::uint64_t{6700417}), 0U);
    EXPECT_EQ(largest / hidden(UINT64_MAX - 1U), 1U);
    EXPECT_EQ(largest % hidden(UINT64_MAX - 1U), 1U);
}

TEST(LibraryDivision, SignedQuotientsTruncateAndRemaindersHaveTheSignOfTheDividend) {
    shows_library_rule();
    struct Case {
        std::int64_t dividend;
        std::int64_t divisor;
        std::int64_t quotient;
        std::int64_t remainder;
    };
    constexpr std::array<Case, 7> cases{{{7, 2, 3, 1},
                                         {-7, 2, -3, -1},
                                         {7, -2, -3, 1},
                                         {-7, -2, 3, -1},
                                         {-1, 2, 0, -1},
                                         {INT64_MIN, 1, INT64_MIN, 0},
                                         {INT64_MIN, INT64_MAX, -1, -1}}};
    for (const Case& one : cases) {
        const std::int64_t dividend = hidden(one.dividend);
        const std::int64_t divisor = hidden(one.divisor);
        EXPECT_EQ(dividend / divisor, one.quotient) << one.dividend << '/' << one.divisor;
        EXPECT_EQ(dividend % divisor, one.remainder) << one.dividend << '%' << one.divisor;
    }
}

}  // namespace canproof::test::library_division
