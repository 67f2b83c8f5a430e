// SPDX-License-Identifier: Apache-2.0
// Computes pitch, roll and gravity angle from the direction of gravity (AX060805, 2.1.3 to 2.1.6).
//
// Every angle differs by less than 0.0001 degree from the result of the same formula in double precision.
#pragma once

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

/// A vector with components along X (forward), Y (right) and Z (down): accelerations or gravity in g.
struct Vector3 {
    float x{0.0F};
    float y{0.0F};
    float z{0.0F};
};

/// Pitch and roll in degrees. Tilt angles: both above -180, up to 180. Euler angles: pitch -90…90, roll above -180, up
/// to 180.
struct PitchRoll {
    float pitch{0.0F};
    float roll{0.0F};
};

/// Returns gravity: the reverse of the acceleration that a sensor at rest measures (the manual's equation 1).
static_assert(implements<req::INC_ANGLE_002>);
constexpr Vector3 gravity_from(const Vector3& acceleration) noexcept {
    return Vector3{-acceleration.x, -acceleration.y, -acceleration.z};
}

/// Returns the length of a vector, in the unit of its components.
float magnitude(const Vector3& vector) noexcept;

/// Returns the tilt angles of the X axis and the Y axis against the ground plane, by the manual's equation 2. They
/// exceed 90 degrees when gravity along Z is negative. Half a turn is always +180, whatever its rounding error.
PitchRoll tilt_angles(const Vector3& gravity) noexcept;

/// Returns the angle between the Z axis and gravity, 0…180 degrees, by the manual's equation 2.
float gravity_angle(const Vector3& gravity) noexcept;

/// Returns the rotations about Y and then X that turn (0, 0, 1) to the direction of gravity (equation 3 of the manual).
/// Near gimbal lock the roll follows noise: see in_gimbal_lock(). Half a turn is +180.
PitchRoll euler_angles(const Vector3& gravity) noexcept;

/// Returns whether the X axis is nearer to the vertical than `cone` degrees (2.1.6).
bool in_gimbal_lock(const Vector3& gravity, float cone) noexcept;

/// Converts a vector to the frame of reference before the installation rotation: undoes the roll about X, then the
/// pitch about Y (2.1.2, 3.4).
Vector3 undo_rotation(const Vector3& vector, const PitchRoll& installation) noexcept;

}  // namespace canproof::ax060805
