// SPDX-License-Identifier: Apache-2.0
// Finds the items whose code or tests differ from a revision, by the functions and test bodies that belong to each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/source/item_work.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// An item whose evidence is stale since a revision.
struct WorkChange {
    std::string id;
    bool code{false};   ///< a function that implements it differs
    bool tests{false};  ///< the body of a test that claims it differs
};

/// Returns the items with other marks, by id. Comments and layout change no mark.
std::vector<WorkChange> work_changes(const WorkByItem& before, const WorkByItem& after);

/// Returns the marks of the sources at a revision, for the items of `content` and the tests in `verdicts`. Reads the
/// revision from a copy in a temporary folder. Throws InputError when git cannot read the revision.
WorkByItem work_at(const std::filesystem::path& root, const std::string& revision,
                   const std::filesystem::path& verdicts, const Register& content);

}  // namespace canproof::host
