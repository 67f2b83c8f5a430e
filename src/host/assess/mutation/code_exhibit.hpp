// SPDX-License-Identifier: Apache-2.0
// The exhibit of the evidence pack for the mutants of code: figures by file, and each survivor with its reason.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Returns the files of the exhibit by name (see host/assess/evidence/exhibit.hpp).
std::map<std::string, std::string> code_exhibit(const std::vector<MutationOutcome>& outcomes);

}  // namespace canproof::host
