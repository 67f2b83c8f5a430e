// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/quotient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "firmware/base/bytes.hpp"

namespace canproof::ax130751 {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns numbers in an order that looks random (a linear congruential generator).
class SomeNumbers {
  public:
    std::uint64_t bits() {
        state_ = (state_ * 6364136223846793005ULL) + 1442695040888963407ULL;
        return (state_ << 32U) ^ (state_ >> 16U);
    }
    /// Returns a number from 2^-500 to 2^500 in size.
    double usual() {
        const std::uint64_t exponent = 523U + (bits() % 1001U);
        return bit_cast<double>((bits() & 0x800FFFFFFFFFFFFFU) | (exponent << 52U));
    }

  private:
    std::uint64_t state_{1};
};

}  // namespace

TEST(Ax130751Quotient, EqualsTheDivisionOfTheLanguageForNumbersOfAllSizes) {
    SomeNumbers some;
    for (int i = 0; i < 20000; ++i) {
        const double dividend = some.usual();
        const double divisor = some.usual();
        ASSERT_EQ(quotient(dividend, divisor), dividend / divisor) << dividend << " / " << divisor;
    }
}

TEST(Ax130751Quotient, EqualsTheDivisionOfTheLanguageForNumbersWithFewDigits) {
    for (int dividend = -60; dividend <= 60; ++dividend) {
        for (int divisor = 1; divisor <= 60; ++divisor) {
            ASSERT_EQ(quotient(dividend, divisor), static_cast<double>(dividend) / divisor)
                << dividend << " / " << divisor;
            ASSERT_EQ(quotient(dividend, 0.001 * divisor), static_cast<double>(dividend) / (0.001 * divisor))
                << dividend;
        }
    }
}

TEST(Ax130751Quotient, RoundsBesideAPowerOfTwo) {
    const double above = std::nextafter(1.0, 2.0);
    const double below = std::nextafter(1.0, 0.0);
    for (const double dividend : {below, 1.0, above, std::nextafter(2.0, 0.0)}) {
        for (const double divisor : {below, 1.0, above, std::nextafter(2.0, 0.0)}) {
            EXPECT_EQ(quotient(dividend, divisor), dividend / divisor);
        }
    }
}

TEST(Ax130751Quotient, VerySmallNumbersCountAsZero) {
    EXPECT_EQ(quotient(0.0, 3.0), 0.0);
    EXPECT_EQ(quotient(1.0e-310, 1.0e-3), 0.0);
    EXPECT_EQ(quotient(1.0e-200, 1.0e200), 0.0);
    EXPECT_EQ(quotient(1.0e-200, -1.0e-100), -1.0e-200 / 1.0e-100);
    EXPECT_EQ(quotient(1.0, 1.0e-310), infinity);
    EXPECT_EQ(quotient(-1.0, 0.0), -infinity);
}

TEST(Ax130751Quotient, VeryLargeNumbersCountAsInfinity) {
    EXPECT_EQ(quotient(1.0e200, 1.0e-200), infinity);
    EXPECT_EQ(quotient(-infinity, 2.0), -infinity);
    EXPECT_EQ(quotient(infinity, -2.0), -infinity);
    EXPECT_EQ(quotient(5.0, infinity), 0.0);
    EXPECT_TRUE(std::isnan(quotient(std::nan(""), 2.0)));
}

}  // namespace canproof::ax130751
