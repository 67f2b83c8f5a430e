// SPDX-License-Identifier: Apache-2.0
// Writes the table of theorems for the evidence pack.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Returns the files of the folder build/exhibits/proofs by name: exhibit.json, the table as CSV and as JSON, and the
/// assumptions as CSV. The exhibit (the result that the evidence pack shows) holds when every theorem of the table is
/// proven; it names the files of theorems that were left out.
std::map<std::string, std::string> exhibit_of(const std::vector<TheoremResult>& results,
                                              const std::vector<std::string>& left_out);

}  // namespace canproof::host::prove
