// Lengths of strings.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Strings without a length get that of their default.
void resolve_lengths(Part& part);

}  // namespace canproof::host
