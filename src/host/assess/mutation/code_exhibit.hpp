// What the evidence pack shows of the mutants of code: figures by file, and each survivor with its
// reason.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Files of an exhibit (see host/evidence/exhibit.hpp) by name.
std::map<std::string, std::string> code_exhibit(const std::vector<MutationOutcome>& outcomes);

}  // namespace canproof::host
