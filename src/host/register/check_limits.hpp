// SPDX-License-Identifier: Apache-2.0
// Checks the limits of entries.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of the limits in one part: the objects to which they refer, their order, and the defaults.
void check_limits(const Part& part, Faults& faults);

}  // namespace canproof::host
