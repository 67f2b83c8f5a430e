// SPDX-License-Identifier: Apache-2.0
// The evidence that a requirement holds: the results of this build's tests, and the places in code that name the
// requirement.
#pragma once

#include <cstdint>
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
    /// source of the test relative to the project's folder; empty when the runner does not report it
    std::string file{};
    unsigned line{0};  ///< line of the test in its source; 0 when the runner does not report it
};

/// One test case of the last run.
struct TestRun {
    std::string name;
    std::string file;
    bool passed{false};
    bool claims{false};  ///< whether the test verifies at least one item
};

struct TestCase {
    std::string suite;
    std::string name;
    bool passed{false};
    std::string failure;  ///< first message of the test if it failed
    double seconds{0.0};
    /// source relative to the project's folder; empty when the runner does not report it
    std::string file{};
    std::vector<std::string> items{};  ///< ids of the items that the test case verifies
};

struct Evidence {
    std::vector<TestCase> cases;
    std::map<std::string, std::vector<Verdict>> verdicts;         ///< results of tests by requirement id
    std::map<std::string, std::vector<std::string>> implemented;  ///< places `src/…:line` by requirement id
    /// ids of the shared requirements that implement other requirements (`by`), by the id of the other requirement
    std::map<std::string, std::string> implemented_by;
    /// places where code names what is generated from an item, by the id of the item
    std::map<std::string, std::vector<std::string>> used;
    /// hashes of the present code and tests of each item (review marks)
    WorkByItem work;
    std::vector<TestRun> runs;
    /// files of the firmware that belong to no requirement, directly or by inclusion
    std::vector<std::string> untraced;
    std::vector<std::string> misplaced;  ///< badly placed links (implements<> assertions), one sentence each
    std::size_t tests{0};
    std::size_t failed{0};
};

/// Returns the id that the code of the item `id` must name in implements<>: the id of the shared requirement that
/// implements the item (`by`), or else `id`.
const std::string& implementing_id(const std::string& id, const Evidence& evidence);

/// Returns the folder with the results of the last test run: the newest among build/release/verdicts,
/// build/debug/verdicts and build/coverage/verdicts. Returns build/release/verdicts when there are no results.
std::filesystem::path newest_verdicts(const std::filesystem::path& root);

/// Selects the content of `Evidence::work`: only the review marks of each item, or its functions and tests as well.
enum class WorkDetail : std::uint8_t { marks, parts };

/// Reads the results of one test program. Throws InputError for a file that is not XML.
Evidence read_verdict_file(const std::filesystem::path& file);

/// Reads the results of tests in one folder. Throws InputError for a file that is not XML.
Evidence read_verdict_files(const std::filesystem::path& verdicts);

/// Reads the XML of the test programs and scans src/ for implements<>. For each requirement that a test case verifies,
/// its XML has a property with the name of this requirement. Throws InputError when there are no results.
/// `detail`: whether `work` also lists the functions and tests of each item, which takes longer.
Evidence collect_evidence(const std::filesystem::path& root, const std::filesystem::path& verdicts,
                          const Register& content, WorkDetail detail = WorkDetail::marks);

}  // namespace canproof::host
