// A test shows something of an item only when it notices a mutant of it: the audit of reports/kills.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/kill_record.hpp"

namespace canproof::host {

struct KillAudit {
    std::size_t shown{0};                  ///< items of which a passed test notices a mutant
    std::vector<std::string> unnoticed;    ///< items claimed by tests that notice no mutant of them, and by no others
    std::vector<std::string> immutable;    ///< items without mutants
    std::vector<std::string> unjudged;     ///< items that only tests claim which no mutation run has judged as they are
    std::vector<std::string> changed;      ///< tests whose body is another one than when they were judged
    std::vector<std::string> never;        ///< tests with claims that were never judged
    std::vector<std::string> idle;         ///< tests that notice no mutant of anything that they claim
    std::vector<std::string> regressions;  ///< what the record shows and the tests no longer do, each a sentence
};

/// Holds the tests that ran against the record. `ids` are the items to look at; those without any passed test are left
/// to the audit itself. `root` is the project's folder.
KillAudit audit_kills(const std::vector<std::string>& ids, const Evidence& evidence, const KillRecord& record,
                      const std::filesystem::path& root);

/// What the command line says of it.
std::string kill_summary(const KillAudit& audit);

}  // namespace canproof::host
