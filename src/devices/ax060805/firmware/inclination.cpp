// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/inclination.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

static_assert(implements<req::INC_INSTALL_007> && implements<req::INC_FILTER_002> && implements<req::INC_FILTER_005>);
void Inclination::sample(const Vector3& acceleration, const InclinationSettings& settings) noexcept {
    static_cast<void>(filter_.update(undo_rotation(acceleration, settings.calibration), settings.filter_share));
    measuring_ = true;
    update(settings);
}

void Inclination::fail() noexcept {
    measuring_ = false;
    filter_.restart();
}

static_assert(implements<req::INC_ANGLE_011> && implements<req::INC_INSTALL_002> && implements<req::INC_ANGLE_020>);
void Inclination::update(const InclinationSettings& settings) noexcept {
    if (!measuring_) {
        return;
    }
    acceleration_ = undo_rotation(filter_.output(), settings.installation);
    weightless_ = magnitude(acceleration_) < settings.least_gravity;
    if (!weightless_) {
        direction_ = filter_.output();
    }
    const Vector3 gravity =
        gravity_from(weightless_ ? undo_rotation(direction_, settings.installation) : acceleration_);
    roll_unsure_ = settings.euler && in_gimbal_lock(gravity, settings.gimbal_lock_cone);
    static_assert(implements<req::INC_ANGLE_016>);
    PitchRoll angles = settings.euler ? euler_angles(gravity) : tilt_angles(gravity);
    if (!in_gimbal_lock(gravity, generated::ax060805::exact_angle)) {
        rolled_ = direction_;
    } else if (settings.euler) {
        angles.roll = last_roll(settings);
    } else {
        // only Euler angles have gimbal lock
    }
    angles_ = {angles.pitch, angles.roll, gravity_angle(gravity)};
}

/// Returns the Euler roll of the last measured direction of gravity for which the roll was defined. The frame of
/// reference is that of `settings`. Returns 0 if there was no such direction, or if the direction is in gimbal lock in
/// this frame, and so has no roll there.
static_assert(implements<req::INC_ANGLE_008> && implements<req::INC_ANGLE_019>);
float Inclination::last_roll(const InclinationSettings& settings) const noexcept {
    const Vector3 gravity = gravity_from(undo_rotation(rolled_, settings.installation));
    return in_gimbal_lock(gravity, generated::ax060805::exact_angle) ? 0.0F : euler_angles(gravity).roll;
}

static_assert(implements<req::INC_INSTALL_003> && implements<req::INC_INSTALL_004> && implements<req::INC_INSTALL_005>);
std::optional<PitchRoll> Inclination::nulling_angles(const InclinationSettings& settings) const noexcept {
    const Vector3 gravity = gravity_from(filter_.output());
    if (!measuring_ || weightless_ || in_gimbal_lock(gravity, settings.gimbal_lock_cone)) {
        return std::nullopt;
    }
    return euler_angles(gravity);
}

}  // namespace canproof::ax060805
