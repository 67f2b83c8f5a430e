// SPDX-License-Identifier: Apache-2.0
// The exhibits of an evidence pack by their keys. An exhibit is the result of one tool or of one kind of test.
#pragma once

#include <map>
#include <string>

#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

using Exhibits = std::map<std::string, Exhibit>;  ///< results of tools and tests, by their keys

/// Returns the exhibits: those that the pack makes from its own data, and those of other tools. An expected exhibit
/// that is missing has the state `absent`.
Exhibits exhibits_of(const PackInput& input);

}  // namespace canproof::host
