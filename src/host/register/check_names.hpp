// Check of names in the generated C++, and of what [services] says of tables.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Names that are written as C++, and what [services] says.
void check_names(const Part& part, Faults& faults);

}  // namespace canproof::host
