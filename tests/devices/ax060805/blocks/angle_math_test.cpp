// SPDX-License-Identifier: Apache-2.0
// Compares the single-precision trigonometry with the double-precision functions of the C library, which may differ by
// the errors that angle_math.hpp states.
#include "devices/ax060805/firmware/angle_math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

constexpr double pi = 3.14159265358979323846;

}  // namespace

TEST(AngleMath, ArctangentErrsByAtMost30Microdegrees) {
    verifies<req::INC_ANGLE_012>();
    double worst = 0.0;
    for (int step = 0; step < 720000; ++step) {
        const double angle = step * pi / 360000.0 - pi;
        const double radius = 0.1 + (step % 97) * 0.17;
        const auto y = static_cast<float>(radius * std::sin(angle));
        const auto x = static_cast<float>(radius * std::cos(angle));
        const double expected = std::atan2(static_cast<double>(y), static_cast<double>(x)) * 180.0 / pi;
        worst = std::max(worst, std::fabs(static_cast<double>(atan2_degrees(y, x)) - expected));
    }
    EXPECT_LT(worst, 3.0e-5);
}

TEST(AngleMath, ArctangentOfTheAxesIsExact) {
    verifies<req::INC_ANGLE_013, req::INC_ANGLE_018>();
    EXPECT_EQ(atan2_degrees(0.0F, 1.0F), 0.0F);
    EXPECT_EQ(atan2_degrees(1.0F, 0.0F), 90.0F);
    EXPECT_EQ(atan2_degrees(-1.0F, 0.0F), -90.0F);
    EXPECT_EQ(atan2_degrees(0.0F, -1.0F), 180.0F);
    EXPECT_EQ(atan2_degrees(-0.0F, -1.0F), 180.0F);
    EXPECT_EQ(atan2_degrees(1.0F, 1.0F), 45.0F);
    EXPECT_EQ(atan2_degrees(0.0F, 0.0F), 0.0F);
}

TEST(AngleMath, SineAndCosineErrByAtMostTwoTenMillionths) {
    verifies<req::INC_ANGLE_012>();
    double worst = 0.0;
    for (int step = -360000; step <= 360000; ++step) {
        const auto degrees = static_cast<float>(step) / 1000.0F;
        const double radians = static_cast<double>(degrees) * pi / 180.0;
        worst = std::max(worst, std::fabs(static_cast<double>(sine_of_degrees(degrees)) - std::sin(radians)));
        worst = std::max(worst, std::fabs(static_cast<double>(cosine_of_degrees(degrees)) - std::cos(radians)));
    }
    EXPECT_LT(worst, 2.0e-7);
}

TEST(AngleMath, SineAndCosineOfQuarterTurnsAreExact) {
    verifies<req::INC_ANGLE_012>();
    EXPECT_EQ(sine_of_degrees(90.0F), 1.0F);
    EXPECT_EQ(cosine_of_degrees(90.0F), 0.0F);
    EXPECT_EQ(cosine_of_degrees(-180.0F), -1.0F);
    EXPECT_EQ(sine_of_degrees(-90.0F), -1.0F);
    for (const float turn : {360.0F, -360.0F}) {
        EXPECT_EQ(sine_of_degrees(turn), 0.0F);
        EXPECT_EQ(cosine_of_degrees(turn), 1.0F);
        EXPECT_EQ(sine_of_degrees(turn * 0.75F), turn > 0.0F ? -1.0F : 1.0F);
        EXPECT_EQ(cosine_of_degrees(turn * 0.75F), 0.0F);
    }
}

TEST(AngleMath, ExponentialErrsByAtMostFourTenMillionths) {
    verifies<req::INC_FILTER_002>();
    double worst = 0.0;
    for (int step = 0; step <= 4000; ++step) {
        const auto x = static_cast<float>(step) / 1000.0F;
        worst = std::max(worst, std::fabs(static_cast<double>(exp_of_negative(x)) - std::exp(-static_cast<double>(x))));
    }
    EXPECT_LT(worst, 4.0e-7);
}

}  // namespace canproof::test
