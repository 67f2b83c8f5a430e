// SPDX-License-Identifier: Apache-2.0
// Generates the firmware's NodeProfile from device.toml.
#pragma once

#include <string>

#include "host/codegen/cpp_text.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the node's data from device.toml as a NodeProfile in C++.
std::string write_profile(const Part& part, Cells cells = Cells::constant);

}  // namespace canproof::host
