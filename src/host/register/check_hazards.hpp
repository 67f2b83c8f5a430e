// Check of hazards: what they name exists, and they name every output.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Faults of all hazards. A device without any is left alone.
void check_hazards(const Register& content, Faults& faults);

}  // namespace canproof::host
