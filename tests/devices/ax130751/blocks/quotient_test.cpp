// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/quotient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "firmware/base/bytes.hpp"
#include "tests/support/shows_rule.hpp"

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
    test::shows_rule("a quotient of doubles is that of the language");
    SomeNumbers some;
    for (int i = 0; i < 20000; ++i) {
        const double dividend = some.usual();
        const double divisor = some.usual();
        ASSERT_EQ(quotient(dividend, divisor), dividend / divisor) << dividend << " / " << divisor;
    }
}

TEST(Ax130751Quotient, EqualsTheDivisionOfTheLanguageForNumbersWithFewDigits) {
    test::shows_rule("a quotient of doubles is that of the language");
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
    test::shows_rule("a quotient of doubles is that of the language");
    const double above = std::nextafter(1.0, 2.0);
    const double below = std::nextafter(1.0, 0.0);
    for (const double dividend : {below, 1.0, above, std::nextafter(2.0, 0.0)}) {
        for (const double divisor : {below, 1.0, above, std::nextafter(2.0, 0.0)}) {
            EXPECT_EQ(quotient(dividend, divisor), dividend / divisor);
        }
    }
}

TEST(Ax130751Quotient, VerySmallNumbersCountAsZero) {
    test::shows_rule("a quotient of doubles is that of the language");
    EXPECT_EQ(quotient(0.0, 3.0), 0.0);
    EXPECT_TRUE(std::signbit(quotient(0.0, -3.0)));
    EXPECT_EQ(quotient(0.0, 0.0), 0.0);
    EXPECT_EQ(quotient(1.0e-310, 1.0e-3), 0.0);
    EXPECT_EQ(quotient(1.0e-200, 1.0e200), 0.0);
    EXPECT_EQ(quotient(1.0e-200, -1.0e-100), -1.0e-200 / 1.0e-100);
    for (const double dividend : {0.001, 0.5, 1.0}) {
        EXPECT_EQ(quotient(dividend, 0.0), infinity);
        EXPECT_EQ(quotient(dividend, 1.0e-310), infinity);
        EXPECT_EQ(quotient(-dividend, 0.0), -infinity);
    }
}

TEST(Ax130751Quotient, VeryLargeNumbersCountAsInfinity) {
    test::shows_rule("a quotient of doubles is that of the language");
    EXPECT_EQ(quotient(1.0e200, 1.0e-200), infinity);
    EXPECT_EQ(quotient(-infinity, 2.0), -infinity);
    EXPECT_EQ(quotient(infinity, -2.0), -infinity);
    EXPECT_EQ(quotient(-infinity, -2.0), infinity);
    EXPECT_TRUE(std::isnan(quotient(std::nan(""), 2.0)));
}

TEST(Ax130751Quotient, InfiniteDivisorGivesZeroWithTheSignOfTheQuotient) {
    test::shows_rule("a quotient of doubles is that of the language");
    for (const double dividend : {0.0, 5.0, 8.0, 13000.0, 1.0e300, 1.7e308}) {
        EXPECT_EQ(quotient(dividend, infinity), 0.0) << dividend;
        EXPECT_FALSE(std::signbit(quotient(dividend, infinity))) << dividend;
        EXPECT_EQ(quotient(dividend, -infinity), 0.0) << dividend;
        EXPECT_TRUE(std::signbit(quotient(dividend, -infinity))) << dividend;
    }
}

TEST(Ax130751Quotient, DivisorNanGivesNan) {
    test::shows_rule("a quotient of doubles is that of the language");
    for (const double dividend : {0.0, 1.0, -1.0e300, 1.7e308}) {
        EXPECT_TRUE(std::isnan(quotient(dividend, std::nan("")))) << dividend;
        // The last digit alone distinguishes this NaN from infinity.
        EXPECT_TRUE(std::isnan(quotient(dividend, bit_cast<double>(std::uint64_t{0x7FF0000000000001U})))) << dividend;
    }
}

// 2^-1022 is the smallest normal double, and 2^1023 the greatest power of two.
TEST(Ax130751Quotient, BoundsOfTheExactQuotientsAreTwiceTheSmallestDoubleAndTheGreatestPowerOfTwo) {
    test::shows_rule("a quotient of doubles is that of the language");
    const double smallest = std::ldexp(1.0, -1021);
    EXPECT_EQ(quotient(smallest, 1.0), smallest);
    EXPECT_EQ(quotient(smallest, -1.0), -smallest);
    EXPECT_EQ(quotient(std::nextafter(smallest, 0.0), 1.0), 0.0);
    const double greatest = std::ldexp(1.0, 1023);
    EXPECT_EQ(quotient(greatest, 1.0), greatest);
    EXPECT_EQ(quotient(-greatest, 1.0), -greatest);
    EXPECT_EQ(quotient(greatest, std::nextafter(1.0, 2.0)), greatest / std::nextafter(1.0, 2.0));
    EXPECT_EQ(quotient(greatest, 0.5), infinity) << "2^1024 is no double";
    EXPECT_EQ(quotient(1.5 * greatest, 0.5), infinity);
    EXPECT_EQ(quotient(-1.5 * greatest, 0.5), -infinity);
    EXPECT_EQ(quotient(std::nextafter(greatest, 0.0), 1.0), std::nextafter(greatest, 0.0));
}

}  // namespace canproof::ax130751
