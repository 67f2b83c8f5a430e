// The records of reports/mutation.toml: why alterations may survive.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Throws InputError with file, line and remedy.
std::vector<SurvivorRecord> read_survivor_records(const std::filesystem::path& file);
/// `*` any characters, `?` one.
bool matches(const std::string& pattern, const std::string& text);

/// Gives survivors their records. The records that no survivor needs.
std::vector<const SurvivorRecord*> justify(std::vector<MutationOutcome>& outcomes,
                                           const std::vector<SurvivorRecord>& records);

/// The records that are about none of these alterations: what they justified is no longer there.
std::vector<const SurvivorRecord*> without_alteration(const std::vector<SurvivorRecord>& records,
                                                      const std::vector<AlteredCell>& cells);

}  // namespace canproof::host
