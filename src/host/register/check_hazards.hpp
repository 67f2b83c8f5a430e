// SPDX-License-Identifier: Apache-2.0
// Checks the hazards: everything that they name exists, and every output has a hazard.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of all hazards. A device without any hazard gets no faults for its outputs.
void check_hazards(const Register& content, Faults& faults);

}  // namespace canproof::host
