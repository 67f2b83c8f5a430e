// SPDX-License-Identifier: Apache-2.0
// Indices of objects as C++ constants.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns a constant for the index of each object of a device, or of each standard object of the shared rules.
std::string write_indices(const Part& part);

}  // namespace canproof::host
