// SPDX-License-Identifier: Apache-2.0
// Generates C++ code that returns which object a write concerns.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns an enumeration of the objects whose writes the firmware reports to the device, and a function that returns
/// the enumerator for a write.
std::string write_written(const Part& part);

}  // namespace canproof::host
