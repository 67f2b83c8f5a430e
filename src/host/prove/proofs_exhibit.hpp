// SPDX-License-Identifier: Apache-2.0
// Writes the table of theorems for the evidence pack.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Returns the files of the folder build/exhibits/proofs by name: exhibit.json, the table as CSV and as JSON, and the
/// assumptions as CSV. The exhibit (the result that the evidence pack shows) holds when every theorem is proven.
std::map<std::string, std::string> exhibit_of(const std::vector<TheoremResult>& results);

}  // namespace canproof::host::prove
