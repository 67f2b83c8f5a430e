// What shows that a requirement holds: test verdicts of this build, and the places in code that name it.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/assess/source/item_work.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

struct Verdict {
    std::string test;  ///< Suite.Name
    std::string kind;  ///< test, property, fuzz or proof
    bool passed{false};
    double seconds{0.0};
    std::string file{};  ///< source of the test, from the project's folder; empty where the runner does not tell
};

/// One test case of the last run.
struct TestRun {
    std::string name;
    std::string file;
    bool passed{false};
    bool claims{false};  ///< that it shows some item
};

struct TestCase {
    std::string suite;
    std::string name;
    bool passed{false};
    std::string failure;  ///< first message of a case that failed
    double seconds{0.0};
    std::string file{};                ///< source, from the project's folder; empty where the runner does not tell
    std::vector<std::string> items{};  ///< ids that it claims to show
};

struct Evidence {
    std::vector<TestCase> cases;
    std::map<std::string, std::vector<Verdict>> verdicts;         ///< by requirement id
    std::map<std::string, std::vector<std::string>> implemented;  ///< by requirement id: `src/…:line`
    std::map<std::string, std::vector<std::string>> used;  ///< by id: where code names what was generated from it
    WorkByItem work;                                       ///< what a review of each item is about
    std::vector<TestRun> runs;
    std::vector<std::string> untraced;   ///< files of the firmware that serve no requirement, directly or by inclusion
    std::vector<std::string> misplaced;  ///< links that stand where they say little, each a sentence
    std::size_t tests{0};
    std::size_t failed{0};
};

/// Where the last run of the tests left its verdicts: build/NAME/verdicts of the presets release, debug and coverage,
/// the newest of them.
std::filesystem::path newest_verdicts(const std::filesystem::path& root);

/// The verdicts in one folder alone. Throws InputError for what is no XML.
Evidence read_verdict_files(const std::filesystem::path& verdicts);

/// Reads the XML that the test binaries leave (a property of a test case named like a requirement is its claim) and
/// scans src/ for implements<>. Throws InputError when there are no verdicts.
Evidence collect_evidence(const std::filesystem::path& root, const std::filesystem::path& verdicts,
                          const Register& content);

}  // namespace canproof::host
