// SPDX-License-Identifier: Apache-2.0
// The audit of reports/kills.csv. A test shows an item only when it notices a mutant of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/kill_record.hpp"

namespace canproof::host {

struct KillAudit {
    std::size_t shown{0};                ///< items with a passed test that notices a mutant of them
    std::vector<std::string> unnoticed;  ///< items whose tests are all judged and notice no mutant of them
    std::vector<std::string> immutable;  ///< items without mutants
    std::vector<std::string> unjudged;   ///< items that are not shown, but have a test that no mutation run has judged
                                         ///< in its present form
    std::vector<std::string> changed;    ///< tests whose body has changed since they were judged
    std::vector<std::string> never;      ///< tests with claims that were never judged
    std::vector<std::string> idle;       ///< tests that notice no mutant of any claimed item
    std::vector<std::string> regressions;  ///< items that are shown according to the record, but not by the present
                                           ///< tests; one sentence each
};

/// Compares the tests of the last run with the record. `ids` are the items to audit; items without a passed test are
/// left to the audit itself. `root` is the project's folder.
KillAudit audit_kills(const std::vector<std::string>& ids, const Evidence& evidence, const KillRecord& record,
                      const std::filesystem::path& root);

/// Returns the summary for the command line.
std::string kill_summary(const KillAudit& audit);

}  // namespace canproof::host
