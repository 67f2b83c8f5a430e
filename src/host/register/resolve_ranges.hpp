// SPDX-License-Identifier: Apache-2.0
// Resolves `range = { table = … }` of entries: the first input column of the table gives the allowed values.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Stores the allowed values in each range of `part` that names a table. Adds a fault for each range for which this is
/// impossible.
void resolve_ranges(const Register& content, Part& part, Faults& faults);

}  // namespace canproof::host
