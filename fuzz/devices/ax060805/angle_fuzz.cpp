// SPDX-License-Identifier: Apache-2.0
// Compares the firmware's angle arithmetic, for all numbers that it accepts, with the same formulae in long
// double (AX060805, 2.1.2 to 2.1.6). Input: records of fourteen bytes: the function, one unused byte, and three floats.
#include <cmath>
#include <cstring>

#include "devices/ax060805/firmware/angle_math.hpp"
#include "devices/ax060805/firmware/angle_range.hpp"
#include "devices/ax060805/firmware/tilt.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/require.hpp"
#include "generated/ax060805/requirements.hpp"

namespace {

using namespace canproof;
using namespace canproof::ax060805;
using fuzz::require;
using Exact = long double;

constexpr std::size_t record_size = 14;
const Exact radians = std::atan2(0.0L, -1.0L) / 180.0L;

Exact degrees(Exact y, Exact x) {
    return std::atan2(y, x) / radians;
}
/// Returns the difference of two directions in degrees; -180 and 180 are the same direction.
Exact apart(Exact a, Exact b) {
    return std::fabs(std::remainder(a - b, 360.0L));
}

/// Checks that atan2_degrees() has at most the error that angle_math.hpp states, for any finite vector.
void check_direction(float y, float x) {
    if (!std::isfinite(x) || !std::isfinite(y) || (x == 0.0F && y == 0.0F)) {
        return;
    }
    const float found = atan2_degrees(y, x);
    require(found >= -180.0F && found <= 180.0F, "range of a direction");
    require(apart(found, degrees(y, x)) < 3.0e-5L, "direction");
}

void check_sine(float angle) {
    if (!(std::fabs(angle) <= 360.0F)) {
        return;
    }
    require(std::fabs(sine_of_degrees(angle) - std::sin(Exact{angle} * radians)) < 2.0e-7L, "sine");
    require(std::fabs(cosine_of_degrees(angle) - std::cos(Exact{angle} * radians)) < 2.0e-7L, "cosine");
}

void check_exponential(float x) {
    if (x >= 0.0F && x <= 4.0F) {
        require(std::fabs(exp_of_negative(x) - std::exp(-Exact{x})) < 4.0e-7L, "exponential");
    }
}

/// Checks the angles that the firmware computes from the acceleration `g`, if the sensor can measure an acceleration of
/// this length. The tilt angles jump where z changes its sign.
void check_tilt(const Vector3& g) {
    const Exact x = g.x, y = g.y, z = g.z;
    const Exact length = std::sqrt(x * x + y * y + z * z);
    if (!(length >= 0.001L && length <= 16.0L)) {
        return;
    }
    const Exact side = g.z < 0.0F ? -1.0L : 1.0L;
    const PitchRoll tilt = tilt_angles(g);
    const PitchRoll euler = euler_angles(g);
    require(apart(tilt.pitch, degrees(-x, side * std::sqrt(y * y + z * z))) < 1.0e-4L, "tilt pitch");
    require(apart(tilt.roll, degrees(y, side * std::sqrt(x * x + z * z))) < 1.0e-4L, "tilt roll");
    require(apart(gravity_angle(g), degrees(std::sqrt(x * x + y * y), z)) < 1.0e-4L, "gravity angle");
    require(apart(euler.pitch, degrees(-x, std::sqrt(y * y + z * z))) < 1.0e-4L, "Euler pitch");
    require((y == 0.0L && z == 0.0L) || apart(euler.roll, degrees(y, z)) < 1.0e-4L, "Euler roll");
}

/// Checks that undo_rotation(), which removes the installation angles, equals two rotations in long double.
void check_rotation(const Vector3& given) {
    const PitchRoll turn{std::fmod(given.x, 90.0F), std::fmod(given.y, 180.0F)};
    if (!std::isfinite(turn.pitch) || !std::isfinite(turn.roll)) {
        return;
    }
    const Vector3 unit{0.6F, -0.48F, 0.64F};
    const Exact pitch = Exact{turn.pitch} * radians, roll = Exact{turn.roll} * radians;
    const Exact y = std::cos(roll) * unit.y - std::sin(roll) * unit.z;
    const Exact down = std::sin(roll) * unit.y + std::cos(roll) * unit.z;
    const Vector3 found = undo_rotation(unit, turn);
    require(std::fabs(found.x - (std::cos(pitch) * unit.x + std::sin(pitch) * down)) < 1.0e-6L, "rotation x");
    require(std::fabs(found.y - y) < 1.0e-6L, "rotation y");
    require(std::fabs(found.z - (std::cos(pitch) * down - std::sin(pitch) * unit.x)) < 1.0e-6L, "rotation z");
}

void check_span(float angle) {
    if (!(std::fabs(angle) <= 180.0F)) {
        return;
    }
    const float full = in_span(angle, {0, 360});
    const float right = in_span(angle, {0, 90});
    require(full >= 0.0F && full < 360.0F && apart(full, angle) < 1.0e-4L, "whole turn");
    require(right >= 0.0F && right <= 90.0F, "quarter turn");
}

}  // namespace

CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::INC_ANGLE_003, req::INC_ANGLE_004, req::INC_ANGLE_005, req::INC_INSTALL_001,
                     req::INC_RANGE_001, req::INC_RANGE_004, req::INC_RANGE_005)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (; size >= record_size; data += record_size, size -= record_size) {
        float numbers[3]{};
        std::memcpy(numbers, data + 2, sizeof numbers);
        const Vector3 vector{numbers[0], numbers[1], numbers[2]};
        switch (data[0] % 6U) {
            case 0:
                check_direction(numbers[0], numbers[1]);
                break;
            case 1:
                check_sine(numbers[0]);
                break;
            case 2:
                check_exponential(numbers[0]);
                break;
            case 3:
                check_tilt(vector);
                break;
            case 4:
                check_rotation(vector);
                break;
            default:
                check_span(numbers[0]);
        }
    }
    return 0;
}
