// What shows that a requirement holds: test verdicts of this build, and the places in code that name it.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace canproof::host {

struct Verdict {
    std::string test;  ///< Suite.Name
    std::string kind;  ///< test, property or fuzz
    bool passed{false};
};

struct TestCase {
    std::string suite;
    std::string name;
    bool passed{false};
    std::string failure;  ///< first message of a case that failed
};

struct Evidence {
    std::vector<TestCase> cases;
    std::map<std::string, std::vector<Verdict>> verdicts;         ///< by requirement id
    std::map<std::string, std::vector<std::string>> implemented;  ///< by requirement id: `src/firmware/…:line`
    std::size_t tests{0};
    std::size_t failed{0};
};

/// Reads the XML that the test binaries leave (a property of a test case named like a requirement is its claim) and
/// scans src/firmware for implements<>. Throws InputError when there are no verdicts.
Evidence collect_evidence(const std::filesystem::path& root, const std::filesystem::path& verdicts);

}  // namespace canproof::host
