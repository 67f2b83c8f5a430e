// SPDX-License-Identifier: Apache-2.0
// Checks decision tables.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of decision tables: wrong domains, gaps and overlaps. Sets the words of columns with an enumeration.
void check_tables(const Register& content, Part& part, Faults& faults);

}  // namespace canproof::host
