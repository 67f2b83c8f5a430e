// SPDX-License-Identifier: Apache-2.0
// Finds the devices of a run by the names that a user gives.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

/// Returns the position in `names` of the device that `name` means: its whole name, or the part before @ if only one
/// device has it. Throws InputError with the devices of the run.
std::size_t find_device(const std::vector<std::string>& names, const std::string& name);

}  // namespace canproof::host
