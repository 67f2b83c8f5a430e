// SPDX-License-Identifier: Apache-2.0
// The table of theorems for the evidence pack.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Files of the folder build/exhibits/proofs, by name: exhibit.json, the table as CSV, all of it as JSON. It holds when
/// every theorem is proven.
std::map<std::string, std::string> exhibit_of(const std::vector<TheoremResult>& results);

}  // namespace canproof::host::prove
