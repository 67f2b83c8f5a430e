// SPDX-License-Identifier: Apache-2.0
// Angles from gravity by the formulae of the AX060805 manual (2.1.3 to 2.1.6, 3.4), calculated by hand.
#include "devices/ax060805/firmware/tilt.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "devices/ax060805/firmware/angle_range.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

constexpr float half_root_3 = 0.8660254F;  // cos 30°
constexpr float half_root_2 = 0.70710678F;
constexpr float close = 1e-4F;

struct Case {
    const char* position;
    Vector3 gravity;
    PitchRoll tilt;
    float gravity_angle;
    PitchRoll euler;
};

// The tilt pitch is atan2(-gx, s sqrt(gy2 + gz2)), the tilt roll is atan2(gy, s sqrt(gx2 + gz2)), s is the sign of gz.
const std::vector<Case> cases{
    {"level", {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F}, 0.0F, {0.0F, 0.0F}},
    {"nose up 30", {-0.5F, 0.0F, half_root_3}, {30.0F, 0.0F}, 30.0F, {30.0F, 0.0F}},
    {"nose down 30", {0.5F, 0.0F, half_root_3}, {-30.0F, 0.0F}, 30.0F, {-30.0F, 0.0F}},
    {"right side down 45", {0.0F, half_root_2, half_root_2}, {0.0F, 45.0F}, 45.0F, {0.0F, 45.0F}},
    {"left side down 45", {0.0F, -half_root_2, half_root_2}, {0.0F, -45.0F}, 45.0F, {0.0F, -45.0F}},
    // roll: atan2(0.5, sqrt(0.25 + 0.5)) = 30; Euler roll: atan2(0.5, 0.7071) = 35.2644
    {"both", {0.5F, 0.5F, half_root_2}, {-30.0F, 30.0F}, 45.0F, {-30.0F, 35.264390F}},
    {"upside down", {0.0F, 0.0F, -1.0F}, {180.0F, 180.0F}, 180.0F, {0.0F, 180.0F}},
    {"upside down, nose up 30", {-0.5F, 0.0F, -half_root_3}, {150.0F, 180.0F}, 150.0F, {30.0F, 180.0F}},
    {"upside down, nose down 30", {0.5F, 0.0F, -half_root_3}, {-150.0F, 180.0F}, 150.0F, {-30.0F, 180.0F}},
    {"upside down, rolled left", {0.0F, -0.5F, -half_root_3}, {180.0F, -150.0F}, 150.0F, {0.0F, -150.0F}},
    {"upside down, rolled right", {0.0F, 0.5F, -half_root_3}, {180.0F, 150.0F}, 150.0F, {0.0F, 150.0F}},
    {"on its right side", {0.0F, 1.0F, 0.0F}, {0, 90}, 90.0F, {0, 90}},
    {"on its left side", {0.0F, -1.0F, 0.0F}, {0.0F, -90.0F}, 90.0F, {0.0F, -90.0F}},
    {"nose straight up", {-1.0F, 0.0F, 0.0F}, {90.0F, 0.0F}, 90.0F, {90.0F, 0.0F}},
    {"nose straight down", {1.0F, 0.0F, 0.0F}, {-90.0F, 0.0F}, 90.0F, {-90.0F, 0.0F}},
};

void expect_near(const PitchRoll& angles, const PitchRoll& expected, const char* position) {
    EXPECT_NEAR(angles.pitch, expected.pitch, close) << position;
    EXPECT_NEAR(angles.roll, expected.roll, close) << position;
}

void expect_near(const Vector3& vector, const Vector3& expected) {
    EXPECT_NEAR(vector.x, expected.x, 1e-6F);
    EXPECT_NEAR(vector.y, expected.y, 1e-6F);
    EXPECT_NEAR(vector.z, expected.z, 1e-6F);
}

}  // namespace

TEST(Tilt, TiltAnglesFollowEquation2InEveryQuadrant) {
    verifies<req::INC_ANGLE_003, req::INC_ANGLE_006, req::INC_ANGLE_013>();
    for (const auto& one : cases) {
        expect_near(tilt_angles(one.gravity), one.tilt, one.position);
    }
}

TEST(Tilt, GravityAngleFollowsEquation2) {
    verifies<req::INC_ANGLE_004, req::INC_ANGLE_006>();
    for (const auto& one : cases) {
        EXPECT_NEAR(gravity_angle(one.gravity), one.gravity_angle, close) << one.position;
    }
}

TEST(Tilt, EulerAnglesFollowEquation3) {
    verifies<req::INC_ANGLE_005, req::INC_ANGLE_006>();
    for (const auto& one : cases) {
        expect_near(euler_angles(one.gravity), one.euler, one.position);
    }
}

TEST(Tilt, GravityIsTheReversedAcceleration) {
    verifies<req::INC_ANGLE_002>();
    const Vector3 gravity = gravity_from(Vector3{0.25F, -0.5F, -1.0F});
    expect_near(gravity, Vector3{-0.25F, 0.5F, 1.0F});
}

TEST(Tilt, TiltAngleJumpsToItsSupplementWhereGzChangesItsSign) {
    verifies<req::INC_ANGLE_007, req::INC_ANGLE_003>();
    // the pitch is atan2(0.5, ±0.866), the roll is atan2(0.866, ±0.5); the sign is that of gz
    expect_near(tilt_angles({-0.5F, half_root_3, 1e-6F}), {30.0F, 60.0F}, "just above");
    expect_near(tilt_angles({-0.5F, half_root_3, 0.0F}), {30.0F, 60.0F}, "zero");
    expect_near(tilt_angles({-0.5F, half_root_3, -0.0F}), {30.0F, 60.0F}, "negative zero");
    expect_near(tilt_angles({-0.5F, half_root_3, -1e-6F}), {150.0F, 120.0F}, "just below");
}

// An angle within 0.00005 degrees of half a turn counts as half a turn. The sine of 0.00005 degrees is 8.7e-7.
TEST(Tilt, HalfATurnIsPlus180DegreesFromEitherSide) {
    verifies<req::INC_ANGLE_014, req::INC_K_EXACT_ANGLE>();
    for (const float across : {0.0F, -0.0F, 1e-10F, -1e-10F, 8e-7F, -8e-7F}) {
        EXPECT_EQ(tilt_angles({across, 0.0F, -1.0F}).pitch, 180.0F) << across;
        EXPECT_EQ(tilt_angles({0.0F, across, -1.0F}).roll, 180.0F) << across;
        EXPECT_EQ(euler_angles({0.0F, across, -1.0F}).roll, 180.0F) << across;
    }
    EXPECT_NEAR(tilt_angles({1e-5F, 0.0F, -1.0F}).pitch, -179.99943F, close);
    EXPECT_NEAR(tilt_angles({0.0F, -1e-5F, -1.0F}).roll, -179.99943F, close);
    EXPECT_NEAR(euler_angles({0.0F, -1e-5F, -1.0F}).roll, -179.99943F, close);
    EXPECT_LT(euler_angles({0.0F, -1e-6F, -1.0F}).roll, -179.9F);  // 0.000057 degrees beyond half a turn
    EXPECT_LT(euler_angles({0.0F, 1e-6F, -1.0F}).roll, 180.0F);
}

TEST(Tilt, GimbalLockIsAConeAboutTheVertical) {
    verifies<req::INC_ANGLE_016>();
    // sin 1° = 0.0174524
    EXPECT_TRUE(in_gimbal_lock({-1.0F, 0.0F, 0.0F}, 1.0F));
    EXPECT_TRUE(in_gimbal_lock({1.0F, 0.0174F, 0.0F}, 1.0F));
    EXPECT_TRUE(in_gimbal_lock({-1.0F, 0.0F, -0.0174F}, 1.0F));
    EXPECT_FALSE(in_gimbal_lock({-1.0F, 0.0F, 0.0176F}, 1.0F));
    EXPECT_FALSE(in_gimbal_lock({0.0F, 0.0F, 1.0F}, 1.0F));
    EXPECT_TRUE(in_gimbal_lock({-2.0F, 0.0348F, 0.0F}, 1.0F));  // 1.0° from the vertical: the cone is an angle, so the
                                                                // length 2 g does not matter
    EXPECT_FALSE(in_gimbal_lock({-0.5F, 0.0089F, 0.0F}, 1.0F));  // 0.5 sin 1° = 0.00873
    EXPECT_FALSE(in_gimbal_lock({-1.0F, 0.0F, 0.0F}, 0.0F));     // a cone of 0 degrees contains nothing
}

TEST(Tilt, UndoRotationUndoesRollBeforePitch) {
    verifies<req::INC_INSTALL_001>();
    // A level machine whose sensor unit is rolled by 90 and pitched by 30 degrees. Along the axes of the unit, gravity
    // is (-sin 30, cos 30, 0).
    expect_near(undo_rotation({-0.5F, half_root_3, 0.0F}, {30.0F, 90.0F}), {0.0F, 0.0F, 1.0F});
    // Along the axes of this unit, the machine's X axis is (cos 30, sin 30 sin 90, sin 30 cos 90).
    expect_near(undo_rotation({half_root_3, 0.5F, 0.0F}, {30.0F, 90.0F}), {1.0F, 0.0F, 0.0F});
    expect_near(undo_rotation({0.0F, 0.0F, -1.0F}, {30.0F, 90.0F}), {0.0F, 1.0F, 0.0F});
    expect_near(undo_rotation({0.1F, -0.2F, 0.3F}, {0.0F, 0.0F}), {0.1F, -0.2F, 0.3F});
}

TEST(AngleRange, AngleRangeOfPlusMinus180DegreesKeepsTheAngle) {
    verifies<req::INC_RANGE_001>();
    for (const float angle : {-180.0F, -90.0F, -0.25F, 0.0F, 135.0F, 180.0F}) {
        EXPECT_EQ(in_span(angle, {-180, 180}), angle);
    }
}

TEST(AngleRange, AngleRangeOfAFullTurnAdds360DegreesToNegativeAngles) {
    verifies<req::INC_RANGE_004>();
    const AngleSpan full{0, 360};
    EXPECT_EQ(in_span(0.0F, full), 0.0F);
    EXPECT_EQ(in_span(90.0F, full), 90.0F);
    EXPECT_EQ(in_span(180.0F, full), 180.0F);
    EXPECT_EQ(in_span(-180.0F, full), 180.0F);
    EXPECT_EQ(in_span(-90.0F, full), 270.0F);
    EXPECT_EQ(in_span(-0.5F, full), 359.5F);
    EXPECT_EQ(in_span(-1e-9F, full), 0.0F);  // 360 does not occur
}

TEST(AngleRange, AngleRangeOf90DegreesGivesTheDistanceFromLevel) {
    verifies<req::INC_RANGE_005>();
    const AngleSpan right{0, 90};
    EXPECT_EQ(in_span(30.0F, right), 30.0F);
    EXPECT_EQ(in_span(-30.0F, right), 30.0F);
    EXPECT_EQ(in_span(90.0F, right), 90.0F);
    EXPECT_EQ(in_span(150.0F, right), 30.0F);
    EXPECT_EQ(in_span(-150.0F, right), 30.0F);
    EXPECT_EQ(in_span(180.0F, right), 0.0F);
}

}  // namespace canproof::test
