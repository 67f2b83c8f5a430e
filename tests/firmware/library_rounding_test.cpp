// SPDX-License-Identifier: Apache-2.0
// Tests the functions of the C library that round, compare and take roots. On the microcontroller newlib has them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/support/library_tests.hpp"

namespace canproof::test::library_rounding {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr float infinity_f = std::numeric_limits<float>::infinity();
constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

template <typename T>
struct Case {
    T number;
    T result;
};

/// Rounds each number, and the number with the other sign.
template <typename T, std::size_t N>
void expect_rounded(const std::array<Case<T>, N>& cases) {
    for (const Case<T>& one : cases) {
        EXPECT_TRUE(same(std::round(hidden(one.number)), one.result)) << one.number;
        EXPECT_TRUE(same(std::round(hidden(-one.number)), -one.result)) << -one.number;
    }
}

}  // namespace

TEST(LibraryRounding, RoundGoesToTheNearestDoubleAndFromTheMiddleAwayFromZero) {
    shows_library_rule();
    constexpr std::array<Case<double>, 24> cases{{
        {0.0, 0.0},
        {0x1p-1074, 0.0},
        {0.25, 0.0},
        {0x1.fffffffffffffp-2, 0.0},
        {0.5, 1.0},
        {0.75, 1.0},
        {1.0, 1.0},
        {1.25, 1.0},
        {1.5, 2.0},
        {2.5, 3.0},
        {1000.4999, 1000.0},
        {524287.5, 524288.0},
        {0x1.00001p+20, 0x1.00001p+20},
        {0x1p+20 + 0.25, 0x1p+20},
        {0x1p+20 + 0.5, 0x1p+20 + 1.0},
        {0x1.fffffffffp+30, 0x1p+31},
        {0x1.fffffffeffffep+31, 0x1.fffffffep+31},
        {4294967295.5, 4294967296.0},
        {0x1p+51 + 0.5, 0x1p+51 + 1.0},
        {0x1p+51 - 0.25, 0x1p+51},
        {0x1p+52 + 1.0, 0x1p+52 + 1.0},
        {0x1p+60, 0x1p+60},
        {infinity, infinity},
        {nan, nan},
    }};
    expect_rounded(cases);
}

TEST(LibraryRounding, RoundfGoesToTheNearestFloatAndFromTheMiddleAwayFromZero) {
    shows_library_rule();
    constexpr std::array<Case<float>, 14> cases{{
        {0.0F, 0.0F},
        {0x1p-149F, 0.0F},
        {0.25F, 0.0F},
        {0x1.fffffep-2F, 0.0F},
        {0.5F, 1.0F},
        {0.75F, 1.0F},
        {1.5F, 2.0F},
        {3.0F, 3.0F},
        {2.5F, 3.0F},
        {8388607.5F, 8388608.0F},
        {8388609.0F, 8388609.0F},
        {0x1p+60F, 0x1p+60F},
        {infinity_f, infinity_f},
        {nan_f, nan_f},
    }};
    expect_rounded(cases);
}

TEST(LibraryRounding, FloorfGoesToTheNextLowerWholeNumber) {
    shows_library_rule();
    constexpr std::array<Case<float>, 19> cases{{
        {0.0F, 0.0F},
        {-0.0F, -0.0F},
        {0x1p-149F, 0.0F},
        {-0x1p-149F, -1.0F},
        {0.75F, 0.0F},
        {-0.75F, -1.0F},
        {1.0F, 1.0F},
        {-1.0F, -1.0F},
        {1.75F, 1.0F},
        {-1.25F, -2.0F},
        {8388607.5F, 8388607.0F},
        {-8388607.5F, -8388608.0F},
        {8388609.0F, 8388609.0F},
        {-8388609.0F, -8388609.0F},
        {-2.0F, -2.0F},
        {0x1p+60F, 0x1p+60F},
        {infinity_f, infinity_f},
        {-infinity_f, -infinity_f},
        {nan_f, nan_f},
    }};
    for (const Case<float>& one : cases) {
        EXPECT_TRUE(same(std::floor(hidden(one.number)), one.result)) << one.number;
    }
}

TEST(LibraryRounding, LroundGoesToTheNearestIntegerAndFromTheMiddleAwayFromZero) {
    shows_library_rule();
    struct Whole {
        double number;
        long nearest;
    };
    constexpr std::array<Whole, 15> cases{{
        {0.0, 0},
        {0x1p-1074, 0},
        {0.25, 0},
        {0x1.fffffffffffffp-2, 0},
        {0.5, 1},
        {0.75, 1},
        {1.0, 1},
        {1.5, 2},
        {2.5, 3},
        {524287.5, 524288},
        {1048576.25, 1048576},
        {1048576.5, 1048577},
        {1073741823.5, 1073741824},
        {2147483646.5, 2147483647},
        {2147483647.25, 2147483647},
    }};
    for (const Whole& one : cases) {
        EXPECT_EQ(std::lround(hidden(one.number)), one.nearest) << one.number;
        EXPECT_EQ(std::lround(hidden(-one.number)), -one.nearest) << -one.number;
    }
    EXPECT_EQ(std::lround(hidden(-2147483648.0)), -2147483647L - 1L);
}

namespace {

/// Checks the functions that return the lesser and the greater of two numbers. They are called by their addresses,
/// because the compiler may swap the operands of a call that it knows.
template <typename T>
void expect_least_and_greatest(T (*const least_of)(T, T), T (*const greatest_of)(T, T), const T small) {
    constexpr T infinite = std::numeric_limits<T>::infinity();
    constexpr T unordered = std::numeric_limits<T>::quiet_NaN();
    const std::array<T, 9> ascending{{-infinite, T(-1.5), -small, -std::numeric_limits<T>::denorm_min(), T{0},
                                      std::numeric_limits<T>::denorm_min(), small, T(1.5), infinite}};
    for (std::size_t first = 0; first < ascending.size(); ++first) {
        const T one = ascending[first];
        for (std::size_t second = first; second < ascending.size(); ++second) {
            const T other = ascending[second];
            EXPECT_TRUE((least_of(one, other) == one) && (least_of(other, one) == one)) << one << ' ' << other;
            EXPECT_TRUE((greatest_of(one, other) == other) && (greatest_of(other, one) == other))
                << one << ' ' << other;
        }
        EXPECT_TRUE((least_of(one, unordered) == one) && (least_of(unordered, one) == one)) << one;
        EXPECT_TRUE((greatest_of(one, unordered) == one) && (greatest_of(unordered, one) == one)) << one;
    }
    EXPECT_TRUE(std::isnan(least_of(unordered, unordered)) && std::isnan(greatest_of(unordered, unordered)));
}

}  // namespace

TEST(LibraryRounding, LeastAndGreatestOfTwoNumbersIgnoreOneNan) {
    shows_library_rule();
    double (*const least_double)(double, double) = ::fmin;
    double (*const greatest_double)(double, double) = ::fmax;
    expect_least_and_greatest(hidden(least_double), hidden(greatest_double), 0x1p-1023);
    expect_least_and_greatest(hidden(&::fminf), hidden(&::fmaxf), 0x1p-127F);
}

TEST(LibraryRounding, SquareRootsAreTheNearestFloats) {
    shows_library_rule();
    constexpr std::array<Case<float>, 9> cases{{
        {0.0F, 0.0F},
        {-0.0F, -0.0F},
        {1.0F, 1.0F},
        {2.25F, 1.5F},
        {0x1p-148F, 0x1p-74F},
        {0x1p+126F, 0x1p+63F},
        {infinity_f, infinity_f},
        {-1.0F, nan_f},
        {nan_f, nan_f},
    }};
    for (const Case<float>& one : cases) {
        EXPECT_TRUE(same(std::sqrt(hidden(one.number)), one.result)) << one.number;
    }
    EXPECT_EQ(std::sqrt(hidden(2.0F)),
              0x1.6a09e6p+0F);  // 1.41421354; its square is 2 - 4.8e-8, that of the next float 2 + 2.9e-7
}

}  // namespace canproof::test::library_rounding
