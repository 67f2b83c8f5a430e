// SPDX-License-Identifier: Apache-2.0
// Records which tests notice a mutant of the items that they verify. The record is the file reports/kills.csv, which
// `canproof mutate --kills` writes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// The result of the mutation runs for one test.
struct KillLine {
    std::string body;  ///< hash of the test's body when it ran with mutants
    /// items that the test verifies and of which it notices a mutant, sorted by id
    std::vector<std::string> kills;
    /// items that the test verifies and that have no mutants, sorted by id
    std::vector<std::string> without_mutants;
    /// hash of the code of the items that the test verifies, when the test ran with mutants (code_by_test())
    std::string code{};
};

/// The results of the mutation runs by the name of the test, Suite.Name.
using KillRecord = std::map<std::string, KillLine>;

/// Returns, by the test's name, the mark (hash) of the code of all items that a test verifies. The mark changes when
/// the test verifies other items, when the code below a link (implements<> assertion) of such an item changes, or when
/// another shared item implements it (`by`).
std::map<std::string, std::string> code_by_test(const Evidence& evidence);

/// Reads the record; returns an empty record when the file does not exist. A line of four fields, as older versions
/// wrote it, has no hash of the code. Throws InputError with the line of invalid content.
KillRecord read_kill_record(const std::filesystem::path& file);
/// Returns the heading `test,body,kills,without mutants,code` and one line for each test, sorted by name. The third
/// and the fourth field are lists of item ids, separated by spaces.
std::string write_kill_record(const KillRecord& record);

}  // namespace canproof::host
