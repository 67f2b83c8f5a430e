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

/// The bodies of tests in the sources of a project. Reads each source once.
class TestBodies {
  public:
    explicit TestBodies(std::filesystem::path root) : root_{std::move(root)} {}

    /// Sixteen digits that change with the words of the test's body, and not with its comments, spaces and line breaks.
    /// Empty when the source does not define such a test. `file` is named from the project's folder.
    std::string hash(const std::string& file, const std::string& test);

  private:
    std::filesystem::path root_;
    std::map<std::string, std::string> sources_;  ///< by file, without comments and spaces
};

/// A source without comments and without spaces outside literals.
std::string without_layout(const std::string& source);

}  // namespace canproof::host
