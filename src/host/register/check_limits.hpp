// SPDX-License-Identifier: Apache-2.0
// Checks the limits of entries.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in the limits of one part (a device, or the shared rules): references to missing objects, minima
/// above their maxima, and defaults outside their limits.
void check_limits(const Part& part, Faults& faults);

}  // namespace canproof::host
