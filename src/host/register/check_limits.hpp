// Check of limits.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// The limits of one part's entries: the objects they name, their order, and the defaults within.
void check_limits(const Part& part, Faults& faults);

}  // namespace canproof::host
