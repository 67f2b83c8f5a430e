// SPDX-License-Identifier: Apache-2.0
// The exhibit of the evidence pack about mutants of code: figures by file, and the reason for each survivor (a mutant
// that no test notices).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Returns, by name, the files of the exhibit (a result in the evidence pack, see host/assess/evidence/exhibit.hpp).
std::map<std::string, std::string> code_exhibit(const std::vector<MutationOutcome>& outcomes);

}  // namespace canproof::host
