// SPDX-License-Identifier: Apache-2.0
// Checks that everything that a hazard names exists, and that a hazard names each output.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Adds the faults of all hazards. A device without any hazard gets no faults for its outputs.
void check_hazards(const Register& content, Faults& faults);

}  // namespace canproof::host
