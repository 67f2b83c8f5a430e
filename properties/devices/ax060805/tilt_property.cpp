// SPDX-License-Identifier: Apache-2.0
// Properties of the angles of the AX060805 (manual, 2.1, 3.4 and 3.5). The test computes the direction of gravity in
// double precision, for any attitude of the unit.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>

#include "devices/ax060805/firmware/angle_range.hpp"
#include "devices/ax060805/firmware/inclination.hpp"
#include "devices/ax060805/firmware/tilt.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

constexpr double radians = 3.14159265358979323846 / 180.0;
constexpr double stated_error = 1.0e-4;  // degrees

struct Vector {
    double x, y, z;
};

/// Returns any multiple of a millionth of a degree from -`most` to `most` degrees.
double angle(double most) {
    const auto limit = static_cast<int>(most * 1.0e6);
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-limit, limit + 1)) * 1.0e-6;
}

/// Returns vector `v` along the axes of a frame that was turned by yaw, then by pitch, then by roll (section 2.1.5).
Vector seen_from(const Vector& v, double yaw, double pitch, double roll) {
    const Vector a{std::cos(yaw) * v.x + std::sin(yaw) * v.y, std::cos(yaw) * v.y - std::sin(yaw) * v.x, v.z};
    const Vector b{std::cos(pitch) * a.x - std::sin(pitch) * a.z, a.y, std::sin(pitch) * a.x + std::cos(pitch) * a.z};
    return Vector{b.x, std::cos(roll) * b.y + std::sin(roll) * b.z, std::cos(roll) * b.z - std::sin(roll) * b.y};
}

Vector3 single(const Vector& v, double length = 1.0) {
    return Vector3{static_cast<float>(v.x * length), static_cast<float>(v.y * length),
                   static_cast<float>(v.z * length)};
}

/// Returns gravity along the axes of a unit in any attitude.
Vector3 any_gravity() {
    return single(seen_from({0.0, 0.0, 1.0}, angle(180) * radians, angle(90) * radians, angle(180) * radians));
}

double degrees(double y, double x) {
    return std::atan2(y, x) / radians;
}

/// Returns the difference of two angles in degrees, as an absolute value; -180 and 180 are the same angle.
double apart(double a, double b) {
    return std::fabs(std::remainder(a - b, 360.0));
}

/// Returns whether Z is so far from 0 that its sign is certain in single precision. The tilt angles jump where the sign
/// changes.
bool is_clear_of_the_jump(const Vector3& gravity) {
    return std::fabs(gravity.z) > 1e-6F;
}

}  // namespace

RC_GTEST_PROP(TiltLaw, AnglesMatchTheFormulaeInDoublePrecision, ()) {
    verifies<req::INC_ANGLE_003, req::INC_ANGLE_004, req::INC_ANGLE_005, req::INC_ANGLE_012>("property");
    const Vector3 g = any_gravity();
    const double x = g.x, y = g.y, z = g.z;
    const double side = z < 0.0 ? -1.0 : 1.0;
    const PitchRoll tilt = tilt_angles(g);
    const PitchRoll euler = euler_angles(g);
    RC_ASSERT(apart(tilt.pitch, degrees(-x, side * std::sqrt(y * y + z * z))) < stated_error);
    RC_ASSERT(apart(tilt.roll, degrees(y, side * std::sqrt(x * x + z * z))) < stated_error);
    RC_ASSERT(apart(gravity_angle(g), degrees(std::sqrt(x * x + y * y), z)) < stated_error);
    RC_ASSERT(apart(euler.pitch, degrees(-x, std::sqrt(y * y + z * z))) < stated_error);
    RC_ASSERT(apart(euler.roll, degrees(y, z)) < stated_error);
}

RC_GTEST_PROP(TiltLaw, TurningTheMachineAboutTheVerticalChangesNoAngle, ()) {
    verifies<req::INC_ANGLE_010>("property");
    const double yaw = angle(180) * radians;
    const double pitch = angle(90) * radians;
    const double roll = angle(180) * radians;
    const Vector3 turned = single(seen_from({0.0, 0.0, 1.0}, yaw, pitch, roll));
    const Vector3 straight = single(seen_from({0.0, 0.0, 1.0}, 0.0, pitch, roll));
    RC_PRE(is_clear_of_the_jump(straight));
    RC_ASSERT(apart(tilt_angles(turned).pitch, tilt_angles(straight).pitch) < stated_error);
    RC_ASSERT(apart(tilt_angles(turned).roll, tilt_angles(straight).roll) < stated_error);
    RC_ASSERT(apart(gravity_angle(turned), gravity_angle(straight)) < stated_error);
    RC_ASSERT(apart(euler_angles(turned).pitch, euler_angles(straight).pitch) < stated_error);
    if (std::fabs(euler_angles(straight).pitch) < 89.0F) {  // in gimbal lock the Euler roll is uncertain
        RC_ASSERT(apart(euler_angles(turned).roll, euler_angles(straight).roll) < stated_error);
    }
}

RC_GTEST_PROP(TiltLaw, GravityAngleIsUnchangedByATurnAboutTheZAxis, ()) {
    verifies<req::INC_ANGLE_015>("property");
    const Vector3 g = any_gravity();
    const Vector turned = seen_from({g.x, g.y, g.z}, angle(180) * radians, 0.0, 0.0);
    RC_ASSERT(apart(gravity_angle(single(turned)), gravity_angle(g)) < stated_error);
}

RC_GTEST_PROP(TiltLaw, TiltAndGravityAnglesDoNotDependOnTheMagnitudeOfGravity, ()) {
    verifies<req::INC_ANGLE_003, req::INC_ANGLE_004>("property");
    const Vector3 g = any_gravity();
    const double length = *rc::gen::inRange(100, 16000) * 1.0e-3;
    const Vector3 longer = single({g.x, g.y, g.z}, length);
    RC_ASSERT(apart(tilt_angles(longer).pitch, tilt_angles(g).pitch) < stated_error);
    RC_ASSERT(apart(tilt_angles(longer).roll, tilt_angles(g).roll) < stated_error);
    RC_ASSERT(apart(gravity_angle(longer), gravity_angle(g)) < stated_error);
}

RC_GTEST_PROP(TiltLaw, MirroredGravityGivesMirroredTiltAngles, ()) {
    verifies<req::INC_ANGLE_003>("property");
    const Vector3 g = any_gravity();
    const PitchRoll straight = tilt_angles(g);
    const PitchRoll sides = tilt_angles({g.x, -g.y, g.z});
    const PitchRoll ends = tilt_angles({-g.x, g.y, g.z});
    RC_ASSERT(apart(sides.pitch, straight.pitch) == 0.0);
    RC_ASSERT(apart(sides.roll, -straight.roll) == 0.0);
    RC_ASSERT(apart(ends.pitch, -straight.pitch) == 0.0);
    RC_ASSERT(apart(ends.roll, straight.roll) == 0.0);
}

RC_GTEST_PROP(TiltLaw, RotationByTheEulerAnglesRestoresTheGravityVector, ()) {
    verifies<req::INC_ANGLE_005>("property");
    const Vector3 g = any_gravity();
    const PitchRoll euler = euler_angles(g);
    const Vector back = seen_from({0.0, 0.0, 1.0}, 0.0, static_cast<double>(euler.pitch) * radians,
                                  static_cast<double>(euler.roll) * radians);
    RC_ASSERT(std::fabs(back.x - g.x) < 2.0e-6);
    RC_ASSERT(std::fabs(back.y - g.y) < 2.0e-6);
    RC_ASSERT(std::fabs(back.z - g.z) < 2.0e-6);
}

RC_GTEST_PROP(InstallationLaw, UndoingTheInitialAnglesRestoresGravityInTheMachineFrame, ()) {
    verifies<req::INC_INSTALL_001>("property");
    const double pitch = angle(90);
    const double roll = angle(180);
    const Vector3 machine = any_gravity();
    const Vector unit = seen_from({machine.x, machine.y, machine.z}, 0.0, pitch * radians, roll * radians);
    const Vector3 back = undo_rotation(single(unit), {static_cast<float>(pitch), static_cast<float>(roll)});
    RC_ASSERT(std::fabs(back.x - machine.x) < 1.0e-6F);
    RC_ASSERT(std::fabs(back.y - machine.y) < 1.0e-6F);
    RC_ASSERT(std::fabs(back.z - machine.z) < 1.0e-6F);
}

RC_GTEST_PROP(InstallationLaw, AutoNullMakesAllAnglesOfAStillMachineZero, ()) {
    verifies<req::INC_INSTALL_004>("property");
    const Vector3 unit = any_gravity();
    RC_PRE(!in_gimbal_lock(unit, 1.0F));
    const Vector3 machine = undo_rotation(unit, euler_angles(unit));
    RC_ASSERT(std::fabs(tilt_angles(machine).pitch) < stated_error);
    RC_ASSERT(std::fabs(tilt_angles(machine).roll) < stated_error);
    RC_ASSERT(std::fabs(euler_angles(machine).pitch) < stated_error);
    RC_ASSERT(std::fabs(euler_angles(machine).roll) < stated_error);
    RC_ASSERT(std::fabs(gravity_angle(machine)) < stated_error);
}

namespace {

/// Returns random settings of the angles, as the device derives them from its parameters. In a quarter of the cases the
/// pitch and roll of the installation are multiples of 90 degrees.
InclinationSettings any_settings() {
    InclinationSettings settings;
    const bool right_angles = *rc::gen::inRange(0, 4) == 0;
    const auto quarters = [](int most) { return static_cast<float>(90 * *rc::gen::inRange(-most, most + 1)); };
    settings.installation = right_angles ? PitchRoll{quarters(1), quarters(2)}
                                         : PitchRoll{static_cast<float>(angle(90)), static_cast<float>(angle(180))};
    settings.euler = *rc::gen::arbitrary<bool>();
    settings.gimbal_lock_cone = 1.0F;
    settings.least_gravity = 0.1F;
    return settings;
}

}  // namespace

// The angles depend only on the last direction of gravity and on the present settings, and not on earlier directions or
// settings.
RC_GTEST_PROP(InclinationLaw, AnglesDependOnlyOnTheLastGravityDirectionAndThePresentSettings, ()) {
    verifies<req::INC_ANGLE_008, req::INC_ANGLE_016, req::INC_ANGLE_011>("property");
    Inclination inclination;
    InclinationSettings settings = any_settings();
    Vector3 last = any_gravity();
    inclination.sample(last, settings);
    for (int steps = *rc::gen::inRange(0, 6); steps > 0; --steps) {
        switch (*rc::gen::inRange(0, 3)) {
            case 0:
                last = *rc::gen::inRange(0, 4) == 0 ? Vector3{1.0F, 0.0F, 0.0F} : any_gravity();
                inclination.sample(last, settings);
                break;
            case 1:
                inclination.sample(single({last.z, last.x, last.y}, 0.05), settings);
                break;
            default:
                settings = any_settings();
                inclination.update(settings);
                break;
        }
    }
    RC_PRE(!in_gimbal_lock(undo_rotation(last, settings.installation), 0.00005F));
    Inclination fresh;
    fresh.sample(last, settings);
    RC_ASSERT(inclination.angles() == fresh.angles());
    RC_ASSERT(inclination.is_roll_unsure() == fresh.is_roll_unsure());
}

RC_GTEST_PROP(AngleRangeLaw, AnglesStayInTheSelectedRangeAndTheRange0To360KeepsTheirDirection, ()) {
    verifies<req::INC_RANGE_001, req::INC_RANGE_004, req::INC_RANGE_005>("property");
    const auto given = static_cast<float>(angle(180));
    const float full = in_span(given, {0, 360});
    const float right = in_span(given, {0, 90});
    RC_ASSERT(full >= 0.0F && full < 360.0F);
    RC_ASSERT(right >= 0.0F && right <= 90.0F);
    RC_ASSERT(apart(full, given) < 1.0e-4);
    RC_ASSERT(in_span(given, {-180, 180}) == given);
    // `right` is the angle between 0 and 90 degrees with the same slope: |sin(right)| = |sin(given)|.
    RC_ASSERT(std::fabs(std::sin(right * radians) - std::fabs(std::sin(given * radians))) < 1.0e-6);
}

}  // namespace canproof::test
