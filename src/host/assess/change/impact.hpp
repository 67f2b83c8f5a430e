// SPDX-License-Identifier: Apache-2.0
// The impact of a change: the changed items with their decisions, code and tests, and the test results that have
// changed.
#pragma once

#include <string>
#include <vector>

#include "host/assess/change/register_diff.hpp"
#include "host/assess/change/work_change.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

struct VerdictChange {
    std::string id;
    std::string before;  ///< result of the item before the change: `passed`, `failed` or `none`
    std::string after;
};

/// Returns the items whose result differs between `before` and `after`. The result of an item is `passed` when all
/// tests that verify it passed, `failed` when one of them failed, and `none` when no test verifies it.
std::vector<VerdictChange> verdict_changes(const Evidence& before, const Evidence& after);

struct Impact {
    std::vector<ItemChange> items;
    std::vector<std::string> files;  ///< changed files in the folders of code and tests
    std::vector<VerdictChange> verdicts;
    std::vector<WorkChange> stale;  ///< items whose code or tests changed, compared function by function

    bool empty() const { return items.empty() && files.empty() && verdicts.empty() && stale.empty(); }
};

/// Returns the changes as text: each changed item with its decisions, code and tests, each changed file with its items,
/// the changed test results, and the items whose evidence is out of date. The last line has the numbers of changed
/// items, changed files, affected items and changed test results.
std::string write_impact(const Impact& impact, const Register& content, const Evidence& evidence);

/// Returns the changes as JSON. Leaves out the decisions, code and tests of the items.
std::string impact_json(const Impact& impact);

}  // namespace canproof::host
