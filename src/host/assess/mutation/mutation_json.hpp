// SPDX-License-Identifier: Apache-2.0
// The results of `canproof mutate` as JSON, for the audit and the pack.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

std::string write_mutation_json(const std::vector<MutationOutcome>& outcomes);
/// Reads the counts; returns none when the file does not exist. Throws InputError for other content.
CountsByItem read_mutation_json(const std::filesystem::path& file);

}  // namespace canproof::host
