// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/simulation/inclinometer_plant.hpp"

#include <algorithm>
#include <cmath>

#include "devices/ax060805/firmware/low_pass.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;

constexpr double pi = 3.14159265358979323846;

static_assert(implements<req::INC_T62>);
float resolution_of(std::uint16_t part) {
    const auto* const row = own::sensor_accuracy::find(part);
    return row == nullptr ? 0.0F : row->resolution;
}

Vector3 felt(double gx, double gy, double gz) {
    return Vector3{static_cast<float>(-gx), static_cast<float>(-gy), static_cast<float>(-gz)};
}

/// Returns the acceleration that the sensor measures at rest at this pitch and roll (2.1.5): gravity reversed.
Vector3 felt_by_angles(double pitch_deg, double roll_deg) {
    const double pitch = pitch_deg * pi / 180.0;
    const double roll = roll_deg * pi / 180.0;
    return felt(-std::sin(pitch), std::sin(roll) * std::cos(pitch), std::cos(roll) * std::cos(pitch));
}

/// Returns the acceleration that the sensor measures at rest with this attitude. Gravity, the earth's Z axis in the
/// unit, is the third row of the rotation matrix of the quaternion. A quaternion of length zero means no rotation.
Vector3 felt_by_quaternion(double w, double x, double y, double z) {
    const double length = w * w + x * x + y * y + z * z;
    if (length < 1.0e-12) {
        return felt(0.0, 0.0, 1.0);
    }
    return felt(2.0 * (x * z - w * y) / length, 2.0 * (y * z + w * x) / length,
                (w * w - x * x - y * y + z * z) / length);
}

bool begins_with(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
}

}  // namespace

static_assert(implements<req::INC_PLANT_006> && implements<req::INC_K_RESOLUTION_FACTOR> &&
              implements<req::INC_K_RATED_CUT_OFF>);
double sample_noise(double resolution_deg) {
    const double angle_deg = resolution_deg / static_cast<double>(own::resolution_factor);
    const auto share =
        static_cast<double>(low_pass_coefficient(own::rated_cut_off, microseconds(own::sample_period_us)));
    // A first-order filter leaves share / (2 - share) of the variance of white noise. Near level, the
    // angle in radians equals the acceleration along the axis in g.
    return angle_deg * pi / 180.0 / std::sqrt(share / (2.0 - share));
}

static_assert(implements<req::INC_PLANT_001> && implements<req::INC_PLANT_013>);
void InclinometerPlant::stimulus(const std::string& name, ax060805::Inputs& inputs) {
    if (name == "pitch" || name == "roll") {
        rest_ = felt_by_angles(static_cast<double>(inputs.pitch), static_cast<double>(inputs.roll));
    } else if (begins_with(name, "attitude_")) {
        rest_ = felt_by_quaternion(static_cast<double>(inputs.attitude_w), static_cast<double>(inputs.attitude_x),
                                   static_cast<double>(inputs.attitude_y), static_cast<double>(inputs.attitude_z));
    } else if (begins_with(name, "acceleration_")) {
        take_axis(name.back(), inputs);
    } else if (name == "connector_voltage") {
        static_assert(implements<req::INC_PLANT_003> && implements<req::INC_K_SUPPLY_DROP>);
        inputs.supply_voltage = std::max(0.0F, inputs.connector_voltage - own::supply_drop);
    } else if (name == "noise_seed") {
        static_assert(implements<req::INC_PLANT_007>);
        noise_.seed(inputs.noise_seed);
    }
    add_noise(inputs);
}

/// Takes the acceleration of one axis from `inputs`. The other axes keep their last values, without noise.
void InclinometerPlant::take_axis(char axis, const ax060805::Inputs& inputs) {
    if (axis == 'x') {
        rest_.x = inputs.acceleration_x;
    } else if (axis == 'y') {
        rest_.y = inputs.acceleration_y;
    } else {
        rest_.z = inputs.acceleration_z;
    }
}

bool InclinometerPlant::is_noisy(const ax060805::Inputs& inputs) const {
    return resolution_of(inputs.noise_of) > 0.0F;
}

static_assert(implements<req::INC_PLANT_002>);
void InclinometerPlant::add_noise(ax060805::Inputs& inputs) {
    const double scatter = sample_noise(static_cast<double>(resolution_of(inputs.noise_of)));
    const bool noisy = is_noisy(inputs);
    const Vector3 felt = with_errors(rest_, errors_, static_cast<double>(inputs.sensor_temperature));
    inputs.acceleration_x = noisy ? felt.x + static_cast<float>(scatter * normal()) : felt.x;
    inputs.acceleration_y = noisy ? felt.y + static_cast<float>(scatter * normal()) : felt.y;
    inputs.acceleration_z = noisy ? felt.z + static_cast<float>(scatter * normal()) : felt.z;
}

/// Returns a normally distributed number by the Box-Muller method; std::normal_distribution differs between libraries.
double InclinometerPlant::normal() {
    constexpr double range = 4294967296.0;
    const double radius = std::sqrt(-2.0 * std::log((static_cast<double>(noise_()) + 1.0) / range));
    return radius * std::cos(2.0 * pi * static_cast<double>(noise_()) / range);
}

}  // namespace canproof::ax060805
