// SPDX-License-Identifier: Apache-2.0
// The exhibits of an evidence pack by their keys. An exhibit is the result of one tool or of one kind of test.
#pragma once

#include <map>
#include <string>

#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

using Exhibits = std::map<std::string, Exhibit>;  ///< results of tools and tests, by their keys

/// Returns the exhibits of the pack itself and of other tools. Expected exhibits that are missing have the state
/// `absent`.
Exhibits exhibits_of(const PackInput& input);

}  // namespace canproof::host
