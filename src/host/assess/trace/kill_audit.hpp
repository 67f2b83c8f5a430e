// SPDX-License-Identifier: Apache-2.0
// The audit of reports/kills.csv. A test shows an item only if it notices a mutant of the item.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/kill_record.hpp"

namespace canproof::host {

struct KillAudit {
    std::size_t shown{0};                ///< number of items with a passed test that notices a mutant of the item
    std::vector<std::string> unnoticed;  ///< items whose tests are all judged and notice no mutant of the item
    std::vector<std::string> immutable;  ///< items without mutants
    /// items without a test that is known to notice a mutant of them, but with a test that no mutation run has judged
    /// in its present form
    std::vector<std::string> unjudged;
    std::vector<std::string> changed;     ///< tests whose body has changed since a mutation run judged them
    std::vector<std::string> other_code;  ///< tests that were judged with other code of the items that they verify
    std::vector<std::string> never;       ///< tests that verify items and that no mutation run has judged
    std::vector<std::string> idle;        ///< tests that notice no mutant of any item that they verify
    /// One sentence for each loss. An item is a loss when a test in the record noticed a mutant of it and no test in
    /// its present form does. A test in the record that no longer exists is also a loss. A change of an item's code
    /// alone is no loss: its tests then wait for a mutation run.
    std::vector<std::string> regressions;
};

/// Compares the tests of the last run with the record in reports/kills.csv. `ids` are the items to audit. Ignores items
/// without a passed test, because the audit reports them. `root` is the project's folder.
KillAudit audit_kills(const std::vector<std::string>& ids, const Evidence& evidence, const KillRecord& record,
                      const std::filesystem::path& root);

/// Returns the summary of the mutation results that `canproof audit` prints.
std::string kill_summary(const KillAudit& audit);

}  // namespace canproof::host
