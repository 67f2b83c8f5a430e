// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/tilt.hpp"

#include <cmath>

#include "devices/ax060805/firmware/angle_math.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr float half_turn = 180.0F;

float length(const float a, const float b) noexcept {
    return std::sqrt((a * a) + (b * b));
}

/// Returns atan2_degrees() as an angle above -180 and up to 180. If an angle is so close to half a turn that only
/// rounding decides its sign, it becomes +180.
static_assert(implements<req::INC_ANGLE_013> && implements<req::INC_ANGLE_014> && implements<req::INC_K_EXACT_ANGLE>);
float direction(const float y, const float x) noexcept {
    const float angle = atan2_degrees(y, x);
    return (std::fabs(angle) >= (half_turn - generated::ax060805::exact_angle)) ? half_turn : angle;
}

/// Returns the function sign(x) of the manual (2.1.4): 1 for both zeros.
constexpr float sign_of(const float value) noexcept {
    return (value < 0.0F) ? -1.0F : 1.0F;
}

}  // namespace

float magnitude(const Vector3& vector) noexcept {
    return std::sqrt(((vector.x * vector.x) + (vector.y * vector.y)) + (vector.z * vector.z));
}

static_assert(implements<req::INC_ANGLE_003> && implements<req::INC_ANGLE_006> && implements<req::INC_ANGLE_007>);
PitchRoll tilt_angles(const Vector3& gravity) noexcept {
    const float side = sign_of(gravity.z);
    return PitchRoll{direction(-gravity.x, side * length(gravity.y, gravity.z)),
                     direction(gravity.y, side * length(gravity.x, gravity.z))};
}

static_assert(implements<req::INC_ANGLE_004> && implements<req::INC_ANGLE_015> && implements<req::INC_ANGLE_006>);
float gravity_angle(const Vector3& gravity) noexcept {
    return atan2_degrees(length(gravity.x, gravity.y), gravity.z);
}

static_assert(implements<req::INC_ANGLE_005> && implements<req::INC_ANGLE_006>);
static_assert(implements<req::INC_ANGLE_018>);
PitchRoll euler_angles(const Vector3& gravity) noexcept {
    return PitchRoll{atan2_degrees(-gravity.x, length(gravity.y, gravity.z)), direction(gravity.y, gravity.z)};
}

bool in_gimbal_lock(const Vector3& gravity, const float cone) noexcept {
    return length(gravity.y, gravity.z) < (sine_of_degrees(cone) * magnitude(gravity));
}

static_assert(implements<req::INC_ANGLE_010> && implements<req::INC_INSTALL_001>);
Vector3 undo_rotation(const Vector3& vector, const PitchRoll& installation) noexcept {
    const float sin_roll = sine_of_degrees(installation.roll);
    const float cos_roll = cosine_of_degrees(installation.roll);
    const float sin_pitch = sine_of_degrees(installation.pitch);
    const float cos_pitch = cosine_of_degrees(installation.pitch);
    const float y = (cos_roll * vector.y) - (sin_roll * vector.z);
    const float down = (sin_roll * vector.y) + (cos_roll * vector.z);
    return Vector3{(cos_pitch * vector.x) + (sin_pitch * down), y, (cos_pitch * down) - (sin_pitch * vector.x)};
}

}  // namespace canproof::ax060805
