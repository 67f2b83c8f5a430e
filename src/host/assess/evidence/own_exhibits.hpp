// Exhibits by their key.
#pragma once

#include <map>
#include <string>

#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

using Exhibits = std::map<std::string, Exhibit>;  ///< by key

/// What the pack itself shows, that of other tools, and what a whole pack would have beside them (absent).
Exhibits exhibits_of(const PackInput& input);

}  // namespace canproof::host
