// SPDX-License-Identifier: Apache-2.0
// A device from an EDS, DCF or XDD file.
#pragma once

#include <memory>
#include <string>

#include "host/sim/devices/generic_simulation.hpp"

namespace canproof::host {

/// Reads the description of a device. Prints the values that it assumes to standard error. Throws InputError with every
/// fault of the file.
Part read_eds_part(const std::string& path);
/// Makes a device from the file, as read_eds_part() reads it. Also throws InputError for a PDO that a simulated node
/// does not support (check_served_pdos()).
std::unique_ptr<GenericSimulation> read_eds_device(const std::string& path);

}  // namespace canproof::host
