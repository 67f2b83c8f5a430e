// SPDX-License-Identifier: Apache-2.0
// Tests fixed-point numbers of 64 bits: compares products and polynomials with values calculated by hand.
#include "devices/ax188001/firmware/fixed_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/ax188001/firmware/thermocouple.hpp"
#include "tests/support/shows_rule.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

/// The coefficients of a polynomial. The array is as long as in the firmware, so the tests call the same template
/// instances as the firmware.
using Coefficients = std::array<double, InversePiece::size>;

}  // namespace

TEST(FixedPoint, NumbersHaveStepsOfTwoToTheMinusForty) {
    shows_rule("numbers in fixed point");
    EXPECT_EQ(to_fixed(1.0), 1099511627776);
    EXPECT_EQ(to_fixed(-1.5), -1649267441664);
    EXPECT_EQ(to_fixed(0.9e-12), 0);  // one step is 2^-40 = 9.09e-13
    EXPECT_EQ(to_fixed(0.92e-12), 1);
    EXPECT_EQ(to_fixed(-0.92e-12), -1);
    EXPECT_EQ(to_fixed(0.25F), 274877906944);
    EXPECT_EQ(from_fixed(-549755813888), -0.5);
    EXPECT_EQ(rough(3 * 274877906944), 0.75F);
    EXPECT_EQ(magnitude(-7), 7U);
    EXPECT_EQ(magnitude(7), 7U);
}

TEST(FixedPoint, UpperHalfOfA128BitProductIsAtMost2TooSmall) {
    shows_rule("numbers in fixed point");
    EXPECT_EQ(upper_product(std::uint64_t{1} << 63U, 10U), 5U);
    EXPECT_EQ(upper_product(UINT64_MAX, UINT64_MAX), UINT64_MAX - 2U);  // the exact upper half is UINT64_MAX - 1
    EXPECT_EQ(upper_product(0xFFFFFFFFU, 0xFFFFFFFFU), 0U);
    constexpr std::uint64_t low = 0xFFFFFFFFU;
    std::uint64_t number = 88172645463325252U;
    for (int i = 0; i < 10000; ++i) {
        const std::uint64_t a = number;
        number ^= number << 13U;
        number ^= number >> 7U;
        number ^= number << 17U;
        const std::uint64_t middle = (a >> 32U) * (number & low) + ((a & low) * (number & low) >> 32U);
        const std::uint64_t exact =
            (a >> 32U) * (number >> 32U) + (middle >> 32U) + (((a & low) * (number >> 32U) + (middle & low)) >> 32U);
        ASSERT_LE(upper_product(a, number), exact);
        ASSERT_GE(upper_product(a, number) + 2U, exact) << a << " " << number;
    }
}

TEST(FixedPoint, PolynomialIsEvaluatedAboutTheMiddleOfItsRange) {
    shows_rule("numbers in fixed point");
    // x^2 - 3 x + 5 = (x - 2)^2 + (x - 2) + 3; the middle of -1 to 5 is 2, and the largest distance from it is 3, at
    // most 2^2: `reach` is 2.
    const auto made = fixed_polynomial(Coefficients{5.0, -3.0, 1.0}, 3U, -1.0, 5.0);
    EXPECT_EQ(made.centre, to_fixed(2.0));
    EXPECT_EQ(made.reach, 2U);
    EXPECT_EQ(made.coefficients[0], to_fixed(3.0));
    EXPECT_EQ(made.coefficients[1], to_fixed(4.0));
    EXPECT_EQ(made.coefficients[2], to_fixed(16.0));
    for (double x = -1.9; x < 5.9; x += 0.05) {
        ASSERT_NEAR(from_fixed(made.value(to_fixed(x))), x * x - 3.0 * x + 5.0, 1e-11) << x;
    }
    // At a distance of more than 2^2 from the middle 2, the value is that at the distance 2^2: 23 at 6, 15 at -2.
    EXPECT_NEAR(from_fixed(made.value(to_fixed(1000.0))), 23.0, 1e-11);
    EXPECT_NEAR(from_fixed(made.value(to_fixed(-1000.0))), 15.0, 1e-11);
}

TEST(FixedPoint, PolynomialIsExactAtTheEndsOfItsRange) {
    shows_rule("numbers in fixed point");
    // The polynomial is x, from -1 to 1. With `reach` 0 its value at exactly 1 would be wrong.
    const auto made = fixed_polynomial(Coefficients{0.0, 1.0}, 2U, -1.0, 1.0);
    EXPECT_EQ(made.reach, 1U);
    EXPECT_EQ(made.value(to_fixed(1.0)), to_fixed(1.0));
    EXPECT_EQ(made.value(to_fixed(-1.0)), to_fixed(-1.0));
}

TEST(FixedPoint, PolynomialWithoutTermsIsZero) {
    shows_rule("numbers in fixed point");
    EXPECT_EQ(fixed_polynomial(Coefficients{}, 0U, 0.0, 1.0).value(to_fixed(0.3)), 0);
}

}  // namespace canproof::test
