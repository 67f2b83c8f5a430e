// SPDX-License-Identifier: Apache-2.0
// Checks the hazards: the things that they name exist, and every output has a hazard.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of all hazards. A device without hazards has no faults.
void check_hazards(const Register& content, Faults& faults);

}  // namespace canproof::host
