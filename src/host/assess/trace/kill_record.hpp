// Which tests notice a mutant of what they claim: reports/kills.csv, which `canproof mutate --kills` writes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// What the mutation runs found of one test.
struct KillLine {
    std::string body;                          ///< hash of the test's body as it was then
    std::vector<std::string> kills;            ///< claimed items of which it notices a mutant, sorted
    std::vector<std::string> without_mutants;  ///< claimed items that have no mutant, sorted
};

/// By Suite.Name.
using KillRecord = std::map<std::string, KillLine>;

/// Empty when there is no such file. Throws InputError with the line for what is no record.
KillRecord read_kill_record(const std::filesystem::path& file);
/// One line a test, sorted: `test,body,kills,without mutants`; items stand with spaces between them.
std::string write_kill_record(const KillRecord& record);

}  // namespace canproof::host
