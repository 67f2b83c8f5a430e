// What a run of `canproof mutate` leaves for the audit and the pack.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

std::string write_mutation_json(const std::vector<MutationOutcome>& outcomes);
/// Empty when there is no such file. Throws InputError when it is something else.
CountsByItem read_mutation_json(const std::filesystem::path& file);

}  // namespace canproof::host
