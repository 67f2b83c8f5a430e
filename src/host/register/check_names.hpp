// SPDX-License-Identifier: Apache-2.0
// Checks the names in the generated C++, and the tables to which [services] refers.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in the names of the generated C++ and in [services].
void check_names(const Part& part, Faults& faults);

}  // namespace canproof::host
