// SPDX-License-Identifier: Apache-2.0
// Finds the items whose code or tests differ from those of a git revision. It compares the functions and test bodies of
// each item.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/source/item_work.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// An item whose evidence is out of date, because its code or a test has changed since a revision.
struct WorkChange {
    std::string id;
    bool code{false};   ///< whether a function that implements the item has changed
    bool tests{false};  ///< whether the body of a test that verifies the item has changed
    /// functions and tests that are new, or differ from those of the revision; empty when only functions are gone
    std::vector<WorkPart> parts{};
};

/// Returns the items whose functions or tests differ, in the order of the ids. A change of comments or layout is no
/// difference.
std::vector<WorkChange> work_changes(const WorkByItem& before, const WorkByItem& after);

/// Returns the functions and tests of each item of `content` at a revision. The tests are those of `now`: a test that
/// the revision defines under another name in the same file counts as the same test. Extracts the revision into a
/// temporary folder. Throws InputError when this fails.
WorkByItem work_at(const std::filesystem::path& root, const std::string& revision,
                   const std::filesystem::path& verdicts, const Register& content, const WorkByItem& now);

}  // namespace canproof::host
