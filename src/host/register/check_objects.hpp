// SPDX-License-Identifier: Apache-2.0
// Checks objects.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in object codes, sub-indices, types, defaults and limits of the objects of `part` (a device, or the
/// shared rules), and in the total size of these objects.
void check_objects(const Part& part, Faults& faults);

}  // namespace canproof::host
