// Pitch, roll and gravity angle from the direction of gravity (AX060805, 2.1.3 to 2.1.6).
//
// Every angle lies within 0.0001 degree of the same formula in double precision.
#pragma once

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

/// Along X (forward), Y (right) and Z (down): accelerations or gravity in g.
struct Vector3 {
    float x{0.0F};
    float y{0.0F};
    float z{0.0F};
};

/// Degrees. Tilt: both above -180, to 180. Euler: pitch -90…90, roll above -180, to 180.
struct PitchRoll {
    float pitch{0.0F};
    float roll{0.0F};
};

/// Gravity is what a sensor at rest feels, reversed (equation 1).
static_assert(implements<req::INC_ANGLE_002>);
constexpr Vector3 gravity_from(const Vector3& acceleration) noexcept {
    return Vector3{-acceleration.x, -acceleration.y, -acceleration.z};
}

/// In the unit of its components.
float magnitude(const Vector3& vector) noexcept;

/// Equation 2: the tilt of the X and of the Y axis against the ground plane, beyond 90 degrees when gz is negative.
/// Half a turn is +180, on whichever side of it the last bits are.
PitchRoll tilt_angles(const Vector3& gravity) noexcept;

/// Equation 2: the angle between the Z axis and gravity, 0…180 degrees.
float gravity_angle(const Vector3& gravity) noexcept;

/// Equation 3: the turns about Y and then X that bring (0, 0, 1) to the direction of gravity. Near gimbal lock the roll
/// follows noise: see in_gimbal_lock(). Half a turn is +180.
PitchRoll euler_angles(const Vector3& gravity) noexcept;

/// 2.1.6: the X axis is nearer to the vertical than `cone` degrees.
bool in_gimbal_lock(const Vector3& gravity, float cone) noexcept;

/// The frame of reference that `installation` was turned from: undoes the roll about X, then the pitch about Y (2.1.2,
/// 3.4).
Vector3 undo_rotation(const Vector3& vector, const PitchRoll& installation) noexcept;

}  // namespace canproof::ax060805
