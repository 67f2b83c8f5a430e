#include "firmware/blocks/inclination.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof {

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

static_assert(implements<req::INC_ANGLE_002> && implements<req::INC_ANGLE_003> && implements<req::INC_ANGLE_004> &&
              implements<req::INC_ANGLE_005> && implements<req::INC_ANGLE_007> && implements<req::INC_ANGLE_008> &&
              implements<req::INC_ANGLE_010> && implements<req::INC_ANGLE_011> && implements<req::INC_INSTALL_001> &&
              implements<req::INC_INSTALL_002>);
void Inclination::update(const InclinationSettings& settings) noexcept {
    if (!measuring_) {
        return;
    }
    acceleration_ = undo_rotation(filter_.output(), settings.installation);
    const Vector3 gravity = gravity_from(acceleration_);
    weightless_ = magnitude(gravity) < settings.least_gravity;
    if (weightless_) {
        return;
    }
    PitchRoll angles = settings.euler ? euler_angles(gravity) : tilt_angles(gravity);
    if (!in_gimbal_lock(gravity, settings.gimbal_lock_cone)) {
        free_roll_ = euler_angles(gravity).roll;
    } else if (settings.euler) {
        angles.roll = free_roll_;
    } else {
        // tilt angles have no gimbal lock
    }
    angles_ = {angles.pitch, angles.roll, gravity_angle(gravity)};
}

static_assert(implements<req::INC_INSTALL_003> && implements<req::INC_INSTALL_004> && implements<req::INC_INSTALL_005>);
std::optional<PitchRoll> Inclination::nulling_angles(const InclinationSettings& settings) const noexcept {
    const Vector3 gravity = gravity_from(filter_.output());
    if (!measuring_ || weightless_ || in_gimbal_lock(gravity, settings.gimbal_lock_cone)) {
        return std::nullopt;
    }
    return euler_angles(gravity);
}

}  // namespace canproof
