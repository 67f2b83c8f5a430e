// SPDX-License-Identifier: Apache-2.0
// Tests the conversions between integers, floats and doubles. On the microcontroller the compiler's library computes
// those of doubles and of 64-bit integers (libgcc).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/library_tests.hpp"

namespace canproof::test::library_conversion {
namespace {

/// Converts each number to a double, and back. Each number has at most 53 bits, so that the double is exact.
template <typename T, std::size_t N>
void expect_round_trips(const std::array<T, N>& numbers) {
    for (const T number : numbers) {
        const auto real = static_cast<double>(hidden(number));
        EXPECT_EQ(static_cast<T>(hidden(real)), number);
        EXPECT_EQ(std::signbit(real), number < T{});
    }
}

}  // namespace

TEST(LibraryConversion, IntegersOf32BitsAreExactDoubles) {
    shows_library_rule();
    expect_round_trips(std::array<std::int32_t, 9>{{0, 1, -1, 2, 1000, -1000, 0x55555555, INT32_MAX, INT32_MIN}});
    expect_round_trips(std::array<std::uint32_t, 6>{{0U, 1U, 3U, 0x80000000U, 0xAAAAAAAAU, UINT32_MAX}});
    EXPECT_EQ(static_cast<double>(hidden(std::int32_t{-3})), -0x1.8p+1);
    EXPECT_EQ(static_cast<double>(hidden(std::uint32_t{0x80000001U})), 0x1.00000002p+31);
}

TEST(LibraryConversion, IntegersOfAtMost53BitsAreExactDoubles) {
    shows_library_rule();
    for (unsigned bits = 0U; bits <= 53U; ++bits) {
        const std::int64_t all_ones = (std::int64_t{1} << bits) - 1;
        expect_round_trips(std::array<std::int64_t, 2>{{all_ones, -all_ones}});
        expect_round_trips(std::array<std::uint64_t, 1>{{static_cast<std::uint64_t>(all_ones)}});
    }
    for (unsigned bit = 0U; bit <= 62U; ++bit) {
        const std::int64_t power = std::int64_t{1} << bit;
        expect_round_trips(std::array<std::int64_t, 2>{{power, -power}});
        expect_round_trips(std::array<std::uint64_t, 1>{{static_cast<std::uint64_t>(power) << 1U}});
    }
    expect_round_trips(std::array<std::int64_t, 2>{{0, INT64_MIN}});
}

TEST(LibraryConversion, LongerIntegersAreRoundedToTheNearestDouble) {
    shows_library_rule();
    struct Case {
        std::int64_t number;
        double nearest;
    };
    constexpr std::array<Case, 8> cases{{
        {0x20000000000001, 0x1p+53},  // 2^53 + 1: middle; 2^53 ends with 0
        {0x20000000000002, 0x1.0000000000001p+53},
        {0x20000000000003, 0x1.0000000000002p+53},  // middle
        {0x40000000000003, 0x1.0000000000001p+54},  // 3 of 4: above the middle
        {-0x20000000000001, -0x1p+53},
        {0x7FFFFFFFFFFFFFFF, 0x1p+63},
        {0x7FFFFFFFFFFFFC00, 0x1.fffffffffffffp+62},  // exact: 53 ones
        {0x7FFFFFFFFFFFFDFF, 0x1.fffffffffffffp+62},  // one below the middle
    }};
    for (const Case& one : cases) {
        EXPECT_EQ(static_cast<double>(hidden(one.number)), one.nearest) << one.number;
    }
    EXPECT_EQ(static_cast<double>(hidden(UINT64_MAX)), 0x1p+64);
    EXPECT_EQ(static_cast<double>(hidden(std::uint64_t{0xFFFFFFFFFFFFF800U})), 0x1.fffffffffffffp+63);
}

TEST(LibraryConversion, IntegersOf64BitsAreRoundedToTheNearestFloat) {
    shows_library_rule();
    struct Case {
        std::int64_t number;
        float nearest;
    };
    constexpr std::array<Case, 11> cases{{
        {0, 0.0F},
        {1, 1.0F},
        {-1, -1.0F},
        {0x1000001, 0x1p+24F},         // 2^24 + 1: middle; 2^24 ends with 0
        {0x1000003, 0x1.000004p+24F},  // middle
        {0x100000001, 0x1p+32F},
        {0x1000001000001, 0x1.000002p+48F},    // 2^48 + 2^24 + 1: above the middle
        {0x1000001000000, 0x1p+48F},           // middle
        {-0x1000003000000, -0x1.000004p+48F},  // middle
        {INT64_MAX, 0x1p+63F},
        {INT64_MIN, -0x1p+63F},
    }};
    for (const Case& one : cases) {
        EXPECT_EQ(static_cast<float>(hidden(one.number)), one.nearest) << one.number;
        if (one.number >= 0) {
            EXPECT_EQ(static_cast<float>(hidden(static_cast<std::uint64_t>(one.number))), one.nearest) << one.number;
        }
    }
    EXPECT_EQ(static_cast<float>(hidden(UINT64_MAX)), 0x1p+64F);
    EXPECT_EQ(static_cast<float>(hidden(std::uint64_t{0xFFFFFF0000000000U})), 0x1.fffffep+63F);
}

TEST(LibraryConversion, DoublesAreTruncatedToIntegers) {
    shows_library_rule();
    struct Case {
        double real;
        std::int32_t truncated;
    };
    constexpr std::array<Case, 14> cases{{
        {0.0, 0},
        {-0.0, 0},
        {0x1p-1074, 0},
        {0.999, 0},
        {-0.999, 0},
        {1.0, 1},
        {-1.0, -1},
        {1.999, 1},
        {-1.999, -1},
        {123456.75, 123456},
        {-123456.75, -123456},
        {2147483647.9, INT32_MAX},
        {-2147483648.0, INT32_MIN},
        {-2147483648.9, INT32_MIN},
    }};
    for (const Case& one : cases) {
        EXPECT_EQ(static_cast<std::int32_t>(hidden(one.real)), one.truncated) << one.real;
        EXPECT_EQ(static_cast<std::int64_t>(hidden(one.real)), one.truncated) << one.real;
        if (one.truncated >= 0) {
            EXPECT_EQ(static_cast<std::uint32_t>(hidden(one.real)), static_cast<std::uint32_t>(one.truncated))
                << one.real;
            EXPECT_EQ(static_cast<std::uint64_t>(hidden(one.real)), static_cast<std::uint64_t>(one.truncated))
                << one.real;
        }
    }
    EXPECT_EQ(static_cast<std::uint32_t>(hidden(4294967295.9)), UINT32_MAX);
    EXPECT_EQ(static_cast<std::uint32_t>(hidden(-0.75)), 0U);
    EXPECT_EQ(static_cast<std::uint64_t>(hidden(-0.75)), 0U);
    EXPECT_EQ(static_cast<std::int64_t>(hidden(0x1.00000001p+40)), 0x10000000100);
    EXPECT_EQ(static_cast<std::int64_t>(hidden(-0x1.8p+62)), -0x6000000000000000);
    EXPECT_EQ(static_cast<std::uint64_t>(hidden(0x1.8p+63)), 0xC000000000000000U);
}

TEST(LibraryConversion, FloatsAreTruncatedToIntegersOf64Bits) {
    shows_library_rule();
    EXPECT_EQ(static_cast<std::int64_t>(hidden(-0x1.8p+40F)), -0x18000000000);
    EXPECT_EQ(static_cast<std::int64_t>(hidden(-2.75F)), -2);
    EXPECT_EQ(static_cast<std::int64_t>(hidden(2.75F)), 2);
    EXPECT_EQ(static_cast<std::uint64_t>(hidden(0x1.fffffep+63F)), 0xFFFFFF0000000000U);
    EXPECT_EQ(static_cast<std::uint64_t>(hidden(0.5F)), 0U);
}

TEST(LibraryConversion, EachFloatIsExactAsDouble) {
    shows_library_rule();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    struct Case {
        float single;
        double same;
    };
    constexpr std::array<Case, 9> cases{{
        {0.0F, 0.0},
        {1.5F, 1.5},
        {0x1.fffffep+127F, 0x1.fffffep+127},
        {0x1p-126F, 0x1p-126},
        {0x1p-149F, 0x1p-149},
        {0x1.8p-148F, 0x1.8p-148},
        {0x0.fffffep-126F, 0x0.fffffep-126},
        {0x1p-127F, 0x1p-127},
        {infinity, HUGE_VAL},
    }};
    for (const Case& one : cases) {
        for (const float sign : {1.0F, -1.0F}) {
            const auto wide = static_cast<double>(hidden(sign * one.single));
            EXPECT_EQ(wide, static_cast<double>(sign) * one.same);
            EXPECT_EQ(std::signbit(wide), sign < 0.0F);
            EXPECT_EQ(static_cast<float>(hidden(wide)), sign * one.single);
        }
    }
    EXPECT_TRUE(std::isnan(static_cast<double>(hidden(std::numeric_limits<float>::quiet_NaN()))));
    EXPECT_TRUE(std::isnan(static_cast<float>(hidden(std::numeric_limits<double>::quiet_NaN()))));
}

TEST(LibraryConversion, DoublesAreRoundedToTheNearestFloat) {
    shows_library_rule();
    struct Case {
        double real;
        float nearest;
    };
    constexpr std::array<Case, 15> cases{{
        {0x1.000001p+0, 1.0F},                   // middle; 1.0 ends with 0
        {0x1.000003p+0, 0x1.000004p+0F},         // middle
        {0x1.0000010000001p+0, 0x1.000002p+0F},  // above the middle
        {0x1.ffffffp+0, 2.0F},                   // middle; rounding carries into the exponent
        {0x1p-149, 0x1p-149F},
        {0x1p-150, 0.0F},  // middle between 0 and the least float
        {0x1.0000000000001p-150, 0x1p-149F},
        {0x1.8p-149, 0x1p-148F},              // middle between 1 and 2 steps
        {0x1.4p-148, 0x1p-148F},              // 2.5 steps
        {0x1.000002p-127, 0x1p-127F},         // 2^22 + 0.5 steps
        {0x1.000006p-127, 0x1.000008p-127F},  // 2^22 + 1.5 steps
        {0x1p-200, 0.0F},
        {0x1p-1074, 0.0F},
        {0x1.fffffefffffffp+127, 0x1.fffffep+127F},
        {-0.0, -0.0F},
    }};
    for (const Case& one : cases) {
        for (const double sign : {1.0, -1.0}) {
            const auto narrow = static_cast<float>(hidden(sign * one.real));
            EXPECT_EQ(narrow, static_cast<float>(sign) * one.nearest) << one.real;
            EXPECT_EQ(std::signbit(narrow), std::signbit(sign * one.real)) << one.real;
        }
    }
    EXPECT_EQ(static_cast<float>(hidden(0x1p+128)), std::numeric_limits<float>::infinity());
    EXPECT_EQ(static_cast<float>(hidden(-0x1p+200)), -std::numeric_limits<float>::infinity());
}

}  // namespace canproof::test::library_conversion
