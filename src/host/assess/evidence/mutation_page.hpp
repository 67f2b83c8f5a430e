// The alterations of generated cells as a page of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Markup of the body: each item whose generated cells were altered, and what survived.
std::string mutation_page(const MeasuredMutation& mutation);

}  // namespace canproof::host
