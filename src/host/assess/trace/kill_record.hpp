// SPDX-License-Identifier: Apache-2.0
// Records which tests notice a mutant of the items that they claim to show. The record is the file
// reports/kills.csv, which `canproof mutate --kills` writes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// The result of the mutation runs for one test.
struct KillLine {
    std::string body;  ///< hash of the test's body when it was judged
    /// items that the test claims to show and of which it notices a mutant, sorted by id
    std::vector<std::string> kills;
    /// items that the test claims to show and that have no mutants, sorted by id
    std::vector<std::string> without_mutants;
};

/// The results by the test's name, Suite.Name.
using KillRecord = std::map<std::string, KillLine>;

/// Reads the record; returns an empty record when the file does not exist. Throws InputError with the line of invalid
/// content.
KillRecord read_kill_record(const std::filesystem::path& file);
/// Returns the heading `test,body,kills,without mutants` and one line for each test, sorted by name. The last two
/// fields are lists of item ids, separated by spaces.
std::string write_kill_record(const KillRecord& record);

}  // namespace canproof::host
