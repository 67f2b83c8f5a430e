// Check of objects.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Types, defaults, limits and sub-indices of one part's objects.
void check_objects(const Part& part, Faults& faults);

}  // namespace canproof::host
