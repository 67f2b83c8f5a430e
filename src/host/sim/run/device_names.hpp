// Devices of a run by the names that a user gives them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

/// Where in `names` the device stands that `name` means: the whole name, or what stands before its @ where only one
/// device has that. Throws InputError that lists the devices that run.
std::size_t find_device(const std::vector<std::string>& names, const std::string& name);

}  // namespace canproof::host
