// What the sensor of one AX060805 does beside measuring (5.1.1, Table 62).
#pragma once

#include <cstdint>
#include <string>

#include "devices/ax060805/firmware/tilt.hpp"

namespace canproof::host {

struct SensorErrors {
    double initial{0.0};       ///< deg
    double drift{0.0};         ///< deg at -40 degC, reversed
    double nonlinearity{0.0};  ///< percent of 1 g
    double cross_axis{0.0};    ///< percent
};

/// The part number less its letters, as Table 62 and `noise_of` have it: 60841 for AX060841. 0 for an empty one.
std::uint16_t model_of(const std::string& part_number);

/// The greatest that Table 62 allows a model.
SensorErrors greatest_errors(std::uint16_t model);

/// Acceleration in g with the errors, at that temperature of the sensor in degC.
ax060805::Vector3 with_errors(const ax060805::Vector3& felt, const SensorErrors& errors, double temperature);

}  // namespace canproof::host
