// SPDX-License-Identifier: Apache-2.0
// Determines the values of ranges that name a table.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Copies the values of the named table to each range with `table`. Adds a fault for each range for which this is
/// impossible.
void resolve_ranges(const Register& content, Part& part, Faults& faults);

}  // namespace canproof::host
