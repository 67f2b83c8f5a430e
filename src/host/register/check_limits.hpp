// SPDX-License-Identifier: Apache-2.0
// Checks the limits of entries.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of one part's limits: missing objects to which they refer, limits in the wrong order, and defaults
/// outside them.
void check_limits(const Part& part, Faults& faults);

}  // namespace canproof::host
