// SPDX-License-Identifier: Apache-2.0
// The records of reports/mutation.toml: reasons why alterations may survive.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Reads the records. For invalid content, throws InputError with file, line and fix.
std::vector<SurvivorRecord> read_survivor_records(const std::filesystem::path& file);
/// Returns whether the text matches the pattern: `*` matches any characters, `?` one character.
bool matches(const std::string& pattern, const std::string& text);
/// Returns whether the record gives a reason why this alteration may survive.
bool is_about(const SurvivorRecord& record, const AlteredCell& cell);

/// Assigns to each survivor (an alteration that no test noticed) the record that explains it, if there is one. Returns
/// the records that explain no survivor.
std::vector<const SurvivorRecord*> justify(std::vector<MutationOutcome>& outcomes,
                                           const std::vector<SurvivorRecord>& records);

/// Returns the records that match none of these alterations, because the code or the table has changed since the record
/// was written.
std::vector<const SurvivorRecord*> without_alteration(const std::vector<SurvivorRecord>& records,
                                                      const std::vector<AlteredCell>& cells);

}  // namespace canproof::host
