// SPDX-License-Identifier: Apache-2.0
// The measuring errors of the sensor of one AX060805 (5.1.1, Table 62).
#pragma once

#include <cstdint>
#include <string>

#include "devices/ax060805/firmware/tilt.hpp"

namespace canproof::ax060805 {

struct SensorErrors {
    double initial{0.0};       ///< deg
    double drift{0.0};         ///< deg; error by temperature, linear: 0 at 25 degC, -drift at -40 degC
    double nonlinearity{0.0};  ///< in percent of 1 g
    double cross_axis{0.0};    ///< percent
};

/// Returns the part number without its letters and leading zeros, as the table of sensor accuracies and the input
/// `noise_of` use it: 60841 for AX060841. Returns 0 for a text without a number.
std::uint16_t model_of(const std::string& part_number);

/// Returns the greatest errors that the manual's Table 62 allows for a model; all 0 for a model that is not in the
/// table.
SensorErrors greatest_errors(std::uint16_t model);

/// Returns the acceleration `felt` (in g) with the errors of the sensor at `temperature` (in degC).
Vector3 with_errors(const Vector3& felt, const SensorErrors& errors, double temperature);

}  // namespace canproof::ax060805
