// SPDX-License-Identifier: Apache-2.0
// Finds the devices of a run by the names that a user gives them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

/// Returns the position in `names` of the device with this name. `name` is the complete name of the device, or its part
/// before @ if only one device has it. Throws InputError, with a list of the devices, when no or several devices match.
std::size_t find_device(const std::vector<std::string>& names, const std::string& name);

}  // namespace canproof::host
