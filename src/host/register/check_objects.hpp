// SPDX-License-Identifier: Apache-2.0
// Checks objects.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in object codes, sub-indices, types, defaults and limits of one part's objects, and in their total
/// size.
void check_objects(const Part& part, Faults& faults);

}  // namespace canproof::host
