// SPDX-License-Identifier: Apache-2.0
// Factory data of an AX060805 that no object shows: its angle range and its sensor's errors (3.5, 5.1.1).
#pragma once

#include <string>
#include <vector>

#include "host/sim/devices/factory_key.hpp"

namespace canproof::ax060805 {

/// Returns the keys for the angle range and the sensor errors of a unit with this part number. The limits of the sensor
/// errors are those of its model.
std::vector<host::FactoryKey> sensor_keys(const std::string& part_number);

}  // namespace canproof::ax060805
