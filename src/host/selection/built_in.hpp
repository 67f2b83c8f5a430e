// SPDX-License-Identifier: Apache-2.0
// The requirements register that is embedded in the program.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

const Register& built_in_register();
/// Returns the names and part numbers of all devices.
std::vector<std::string> device_names();
/// Returns whether a device has this name or part number.
bool is_device_name(const std::string& name);
/// Returns the device with this name or part number. Throws InputError when there is none.
const Part& device_named(const std::string& name);

}  // namespace canproof::host
