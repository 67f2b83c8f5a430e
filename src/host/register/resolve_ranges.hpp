// Values of ranges that name a table.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Ranges that name a table get its values.
void resolve_ranges(const Register& content, Part& part, Faults& faults);

}  // namespace canproof::host
