// SPDX-License-Identifier: Apache-2.0
// `canproof diff`: items of the requirements register, code, tests and verdicts that the changes since a revision
// affect.
#pragma once

#include <string>

namespace canproof::host {

struct DiffOptions {
    std::string root{"."};
    std::string revision;
    std::string verdicts;
    std::string old_verdicts;
    bool json{false};
    bool exit_code{false};  ///< exit status 1 when anything changed, as with `git diff --exit-code`
};

/// Prints the items, code, tests and verdicts that the changes since `revision` affect. Returns the exit status: 1 when
/// an item whose tests passed before has another verdict now, or, with `exit_code`, when anything changed.
int diff(const DiffOptions& options);

}  // namespace canproof::host
