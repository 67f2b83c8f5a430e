// SPDX-License-Identifier: Apache-2.0
// Checks objects.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in types, defaults, limits and sub-indices of one part's objects.
void check_objects(const Part& part, Faults& faults);

}  // namespace canproof::host
