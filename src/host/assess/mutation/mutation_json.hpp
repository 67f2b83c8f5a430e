// SPDX-License-Identifier: Apache-2.0
// Reads and writes the results of `canproof mutate` as JSON, for the audit and the evidence pack.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

std::string write_mutation_json(const std::vector<MutationOutcome>& outcomes);
/// Returns the JSON of write_mutation_json() with the faults in reports/mutation.toml, one line each, for `canproof
/// mutate --json`.
std::string write_mutation_run_json(const std::vector<MutationOutcome>& outcomes,
                                    const std::vector<std::string>& faults);
/// Reads the numbers of alterations of each item from a file that write_mutation_json() has made. Returns none when the
/// file does not exist. Throws InputError for other content.
CountsByItem read_mutation_json(const std::filesystem::path& file);

}  // namespace canproof::host
