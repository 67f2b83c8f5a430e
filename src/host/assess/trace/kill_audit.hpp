// SPDX-License-Identifier: Apache-2.0
// Audits reports/kills.csv, the record of the mutants that each test notices. A test proves an item only if it notices
// a mutant of the item.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/kill_record.hpp"

namespace canproof::host {

struct KillAudit {
    std::size_t shown{0};  ///< number of items with a passed test that notices a mutant of the item
    /// items whose tests have all run with mutants, and of which no test notices a mutant
    std::vector<std::string> unnoticed;
    std::vector<std::string> immutable;  ///< items without mutants
    /// items for which it is not known whether a test notices a mutant: at least one of their tests has not run with
    /// mutants in its present form
    std::vector<std::string> unjudged;
    std::vector<std::string> changed;  ///< tests whose body has changed since they ran with mutants
    /// tests for which the code of a verified item has changed since they ran with mutants
    std::vector<std::string> other_code;
    std::vector<std::string> never;  ///< tests that verify items and have never run with mutants
    std::vector<std::string> idle;   ///< tests that notice no mutant of any item that they verify
    /// One sentence for each regression. An item has a regression when a test in the record noticed a mutant of it and
    /// no test in its present form does. A recorded test that no longer exists is also a regression. A change of an
    /// item's code alone is no regression: its tests then wait for a mutation run.
    std::vector<std::string> regressions;
};

/// Compares the tests of the last run with the record in reports/kills.csv. `ids` are the items to audit. Ignores items
/// without a passed test, because the audit reports them. `root` is the project's folder.
KillAudit audit_kills(const std::vector<std::string>& ids, const Evidence& evidence, const KillRecord& record,
                      const std::filesystem::path& root);

/// Returns the summary of the mutation results that `canproof audit` prints.
std::string kill_summary(const KillAudit& audit);

}  // namespace canproof::host
