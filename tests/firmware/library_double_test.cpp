// SPDX-License-Identifier: Apache-2.0
// Tests addition, multiplication, division and comparison of doubles. On the microcontroller the compiler's library
// computes them (libgcc), because its FPU computes floats only. Expected values are exact results, rounded to 53 bits
// by hand: to the nearest number, and in the middle to the one whose last bit is 0.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/library_tests.hpp"

namespace canproof::test::library_double {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();  // 2^1024 - 2^971
constexpr double least_normal = 0x1p-1022;
constexpr double least = 0x1p-1074;  // the least subnormal number

// The compiler may swap the operands of an operation, but not those of a call.
[[gnu::noinline]] double sum(const double first, const double second) {
    return hidden(first) + hidden(second);
}
[[gnu::noinline]] double difference(const double first, const double second) {
    return hidden(first) - hidden(second);
}
[[gnu::noinline]] double product(const double first, const double second) {
    return hidden(first) * hidden(second);
}
[[gnu::noinline]] double quotient(const double first, const double second) {
    return hidden(first) / hidden(second);
}
[[gnu::noinline]] bool is_unordered(const double first, const double second) {
    return std::isunordered(hidden(first), hidden(second));
}

struct Case {
    double first;
    double second;
    double result;
};

template <std::size_t N>
void expect_sums(const std::array<Case, N>& cases) {
    for (const Case& one : cases) {
        EXPECT_TRUE(same(sum(one.first, one.second), one.result)) << one.first << " + " << one.second;
        EXPECT_TRUE(same(sum(one.second, one.first), one.result)) << one.second << " + " << one.first;
        EXPECT_TRUE(same(difference(one.first, -one.second), one.result)) << one.first << " - " << -one.second;
    }
}

template <std::size_t N>
void expect_products(const std::array<Case, N>& cases) {
    for (const Case& one : cases) {
        EXPECT_TRUE(same(product(one.first, one.second), one.result)) << one.first << " * " << one.second;
        EXPECT_TRUE(same(product(one.second, one.first), one.result)) << one.second << " * " << one.first;
        EXPECT_TRUE(same(product(-one.first, one.second), -one.result)) << -one.first << " * " << one.second;
    }
}

template <std::size_t N>
void expect_quotients(const std::array<Case, N>& cases) {
    for (const Case& one : cases) {
        EXPECT_TRUE(same(quotient(one.first, one.second), one.result)) << one.first << " / " << one.second;
        EXPECT_TRUE(same(quotient(-one.first, one.second), -one.result)) << -one.first << " / " << one.second;
    }
}

/// Returns the next number of a sequence without a visible pattern (xorshift), the same in each run.
std::uint64_t next(std::uint64_t& state) {
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    return state;
}

/// Returns a whole number between -2^`bits` and 2^`bits`.
std::int64_t whole_number(std::uint64_t& state, const unsigned bits) {
    const auto size = static_cast<std::int64_t>(next(state) >> (64U - bits));
    return ((next(state) & 1U) != 0U) ? -size : size;
}

}  // namespace

TEST(LibraryDouble, SumsOfWholeNumbersAreExact) {
    shows_library_rule();
    std::uint64_t state = 1U;
    for (int count = 0; count < 500; ++count) {
        const auto first = whole_number(state, 1U + static_cast<unsigned>(next(state) % 52U));
        const auto second = whole_number(state, 1U + static_cast<unsigned>(next(state) % 52U));
        const double total = sum(static_cast<double>(first), static_cast<double>(second));
        ASSERT_EQ(static_cast<std::int64_t>(total), first + second) << first << " + " << second;
    }
}

TEST(LibraryDouble, SumsThatNeedMoreThan53BitsAreRoundedToTheNearestNumber) {
    shows_library_rule();
    expect_sums(std::array<Case, 13>{{
        {1.0, 0x1p-53, 1.0},                                    // middle; 1.0 ends with 0
        {0x1.0000000000001p+0, 0x1p-53, 0x1.0000000000002p+0},  // middle; the next number ends with 0
        {1.0, 0x1.0000000000001p-53, 0x1.0000000000001p+0},     // above the middle
        {1.0, 0x1p-54, 1.0},
        {1.0, 0x1p-55, 1.0},
        {1.0, 0x1p-200, 1.0},
        {1.0, -0x1p-53, 0x1.fffffffffffffp-1},    // exact, because numbers below 1 are twice as dense
        {1.0, -0x1p-54, 1.0},                     // middle
        {1.0, -0x1.8p-54, 0x1.fffffffffffffp-1},  // above the middle
        {0x1.fffffffffffffp+0, 0x1p-52, 2.0},     // carries into the exponent
        {0x1.fffffffffffffp+0, 0x1p-53, 2.0},     // middle; rounding carries into the exponent
        {0x1p+52, 0.5, 0x1p+52},
        {0x1.0000000000001p+52, 0.5, 0x1.0000000000002p+52},
    }});
}

TEST(LibraryDouble, DifferencesOfNumbersThatLieCloseAreExact) {
    shows_library_rule();
    for (int bit = 0; bit <= 52; ++bit) {  // 1 + 2^-bit - 1: `bit` high bits cancel
        const double step = std::ldexp(1.0, -bit);
        EXPECT_TRUE(same(difference(1.0 + step, 1.0), step)) << bit;
        EXPECT_TRUE(same(difference(1.0, 1.0 + step), -step)) << bit;
        const double small = std::ldexp(1.0 + step, -1000);
        EXPECT_TRUE(same(difference(small, std::ldexp(1.0, -1000)), std::ldexp(1.0, -1000 - bit))) << bit;
    }
    expect_sums(std::array<Case, 4>{{
        {1.0, -0x1.fffffffffffffp-1, 0x1p-53},
        {2.0, -0x1.fffffffffffffp+0, 0x1p-52},
        {0x1.00000001p+0, -0x1.0p+0, 0x1p-32},
        {0x1.0000000000003p+0, -0x1.0000000000001p+0, 0x1p-51},
    }});
}

TEST(LibraryDouble, SumsNearZeroAreSubnormalNumbers) {
    shows_library_rule();
    for (int bit = 0; bit <= 51; ++bit) {  // the difference of two normal numbers is 2^(-1023 - bit)
        const double small = std::ldexp(least_normal, -1 - bit);
        EXPECT_TRUE(same(difference(least_normal + small, least_normal), small)) << bit;
        EXPECT_TRUE(same(sum(-least_normal - small, least_normal), -small)) << bit;
    }
    expect_sums(std::array<Case, 9>{{
        {least, least, 0x1p-1073},
        {least, 0.0, least},
        {least, -0.0, least},
        {0x1p-1023, 0x1p-1023, least_normal},
        {0x1.fffffffffffffp-1022, -0x1p-1022, 0x0.fffffffffffffp-1022},
        {0x1.8p-1022, -0x1p-1022, 0x1p-1023},
        {0x1.00000002p-1021, -0x1p-1021, 0x1p-1052},
        {least_normal, -least, 0x0.fffffffffffffp-1022},
        {0x1p-1021, least, 0x1.0000000000000p-1021},  // middle
    }});
}

TEST(LibraryDouble, SumsWithZeroInfinityAndNan) {
    shows_library_rule();
    expect_sums(std::array<Case, 17>{{
        {0.0, 0.0, 0.0},
        {-0.0, -0.0, -0.0},
        {0.0, -0.0, 0.0},
        {1.5, -1.5, 0.0},
        {1.5, 1.5, 3.0},
        {1.5, 0.0, 1.5},
        {0x1p+1023, 0x1p+1023, infinity},
        {largest, largest, infinity},
        {largest, 0x1p+1023, infinity},
        {-0x1.8p+1023, -0x1.4p+1023, -infinity},
        {largest, 0x1p+970, infinity},  // the middle between the largest number and 2^1024
        {largest, 0x1p+969, largest},
        {infinity, 1.0, infinity},
        {infinity, infinity, infinity},
        {infinity, -infinity, nan},
        {nan, 1.0, nan},
        {nan, infinity, nan},
    }});
}

TEST(LibraryDouble, ProductsOfWholeNumbersAreExactAndDivideBack) {
    shows_library_rule();
    std::uint64_t state = 2U;
    for (int count = 0; count < 500; ++count) {
        const auto first = whole_number(state, 1U + static_cast<unsigned>(next(state) % 26U));
        const auto second = whole_number(state, 1U + static_cast<unsigned>(next(state) % 26U));
        const double whole = product(static_cast<double>(first), static_cast<double>(second));
        ASSERT_EQ(static_cast<std::int64_t>(whole), first * second) << first << " * " << second;
        if (second != 0) {
            ASSERT_EQ(static_cast<std::int64_t>(quotient(whole, static_cast<double>(second))), first);
        }
    }
}

TEST(LibraryDouble, ProductsAreRoundedToTheNearestNumber) {
    shows_library_rule();
    expect_products(std::array<Case, 6>{{
        {0x1.0000000000001p+0, 0x1.0000000000001p+0, 0x1.0000000000002p+0},  // 1 + 2^-51 + 2^-104
        {0x1.0000000000001p+0, 1.5, 0x1.8000000000002p+0},                   // middle; 2 steps above 1.5 ends with 0
        {0x1.0000000000003p+0, 1.5, 0x1.8000000000004p+0},                   // middle; 4.5 steps above 1.5
        {0x1.fffffffffffffp+0, 0x1.fffffffffffffp+0, 0x1.ffffffffffffep+1},  // 4 - 2^-50 + 2^-104
        {0x1.8p+0, 0x1.8p+0, 0x1.2p+1},
        {0x1p+1, 0x1.23456789abcdep+0, 0x1.23456789abcdep+1},
    }});
}

TEST(LibraryDouble, ProductsNearZeroAndBeyondTheLargestNumber) {
    shows_library_rule();
    expect_products(std::array<Case, 19>{{
        {least_normal, 0.5, 0x1p-1023},
        {0x1.0000000000001p-1022, 0.5, 0x1p-1023},  // middle; the lower number ends with 0
        {0x1.0000000000003p-1022, 0.5, 0x1.0000000000004p-1023},
        {0x1.8p-1022, 0x1p-33, 0x1.8p-1055},
        {0x1.8p-1022, 0x1p-52, 0x1p-1073},  // 1.5 steps: the middle between 1 and 2
        {least, 0.5, 0.0},                  // middle between 0 and the least number
        {0x1.8p-1073, 0.5, 0x1p-1073},      // 3 / 2 steps
        {least, 0x1p+52, least_normal},
        {0x1.8p-1060, 0x1p+60, 0x1.8p-1000},
        {0x1p-600, 0x1p-600, 0.0},
        {0x1p-538, 0x1p-537, 0.0},  // 2^-1075, the middle
        {0x1.8p-538, 0x1p-537, least},
        {least, least, 0.0},
        {0x1p+600, 0x1p+600, infinity},
        {largest, 0x1.0000000000001p+0, infinity},
        {infinity, 2.0, infinity},
        {infinity, 0.0, nan},
        {nan, 0.0, nan},
        {nan, 2.0, nan},
    }});
    EXPECT_TRUE(same(product(infinity, -infinity), -infinity));
    EXPECT_TRUE(same(product(-0.0, -5.0), 0.0));
}

TEST(LibraryDouble, QuotientsAreRoundedToTheNearestNumber) {
    shows_library_rule();
    expect_quotients(std::array<Case, 7>{{
        {1.0, 3.0, 0x1.5555555555555p-2},  // the next bits are 0101...
        {2.0, 3.0, 0x1.5555555555555p-1},
        {5.0, 3.0, 0x1.aaaaaaaaaaaabp+0},   // the next bits are 1010...
        {1.0, 10.0, 0x1.999999999999ap-4},  // the next bits are 1001...
        {0x1.fffffffffffffp+0, 2.0, 0x1.fffffffffffffp-1},
        {1.0, 0x1.fffffffffffffp+0, 0x1.0000000000001p-1},  // 0.5 + 2^-54 + 2^-107: above the middle
        {3.0, 1.5, 2.0},
    }});
}

TEST(LibraryDouble, QuotientsNearZeroAndBeyondTheLargestNumber) {
    shows_library_rule();
    expect_quotients(std::array<Case, 21>{{
        {least_normal, 2.0, 0x1p-1023},
        {least_normal, 3.0, 0x1.5555555555554p-1024},  // a third, in steps of 2^-1074
        {0x1.8p-1022, 0x1p+40, 0x1.8p-1062},
        {least, 2.0, 0.0},  // middle
        {0x1.8p-1073, 2.0, 0x1p-1073},
        {0x1p-600, 0x1p+600, 0.0},
        {least, least, 1.0},
        {least_normal, least, 0x1p+52},
        {0x1.8p-1060, 1.5, 0x1p-1060},
        {1.0, 0x1p-1060, infinity},
        {1.0, 0x1p-1023, 0x1p+1023},
        {0x1p+1000, 0x1p-1000, infinity},
        {largest, 0.5, infinity},
        {1.0, 0.0, infinity},
        {0.0, 0.0, nan},
        {0.0, 7.0, 0.0},
        {infinity, 3.0, infinity},
        {infinity, 0.0, infinity},
        {3.0, infinity, 0.0},
        {infinity, infinity, nan},
        {nan, 2.0, nan},
    }});
    EXPECT_TRUE(same(quotient(2.0, nan), nan));
    EXPECT_TRUE(same(quotient(infinity, nan), nan));
    EXPECT_TRUE(same(quotient(-1.0, -0.0), infinity));
}

TEST(LibraryDouble, ComparisonsOrderNumbersAndNeverNan) {
    shows_library_rule();
    constexpr std::array<double, 9> ascending{
        {-infinity, -2.0, -1.0, -least, 0.0, least, 1.0, 0x1.0000000000001p+0, infinity}};
    for (std::size_t first = 0; first < ascending.size(); ++first) {
        for (std::size_t second = 0; second < ascending.size(); ++second) {
            const double one = hidden(ascending[first]);
            const double other = hidden(ascending[second]);
            EXPECT_EQ(one < other, first < second) << one << ' ' << other;
            EXPECT_EQ(one <= other, first <= second) << one << ' ' << other;
            EXPECT_EQ(one > other, first > second) << one << ' ' << other;
            EXPECT_EQ(one >= other, first >= second) << one << ' ' << other;
            EXPECT_EQ(one == other, first == second) << one << ' ' << other;
            EXPECT_FALSE(is_unordered(one, other));
        }
        const double one = hidden(ascending[first]);
        for (const double unordered : {hidden(nan), hidden(-nan)}) {
            EXPECT_FALSE((one < unordered) || (one <= unordered) || (one > unordered) || (one >= unordered) ||
                         (one == unordered));
            EXPECT_FALSE((unordered < one) || (unordered <= one) || (unordered > one) || (unordered >= one) ||
                         (unordered == one));
            EXPECT_TRUE(is_unordered(one, unordered) && is_unordered(unordered, one));
        }
    }
    EXPECT_TRUE((hidden(0.0) == hidden(-0.0)) && (hidden(0.0) <= hidden(-0.0)) && !(hidden(-0.0) < hidden(0.0)));
}

}  // namespace canproof::test::library_double
