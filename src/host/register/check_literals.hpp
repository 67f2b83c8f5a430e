// SPDX-License-Identifier: Apache-2.0
// Checks constants, enumerations and signals.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults in types, names and values of constants, enumerations and signals.
void check_literals(const Part& part, Faults& faults);

}  // namespace canproof::host
