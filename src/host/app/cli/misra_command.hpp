// SPDX-License-Identifier: Apache-2.0
// `canproof misra`: checks the firmware against MISRA C++:2023.
#pragma once

#include <string>

namespace canproof::host {

struct MisraOptions {
    std::string root{"."};
    std::string build;        ///< folder with a built firmware; empty: build/release or build/debug
    std::string out;          ///< folder for misra.sarif, compliance.md and misra.html; empty: BUILD/misra
    std::string review_file;  ///< file that `reviewer` has reviewed for the rule `review_rule`; empty: runs the check
    std::string review_rule;
    std::string reviewer;
    std::string judgement;
    bool json{false};  ///< the result as JSON instead of lines
};

/// Runs misra/run, which checks the firmware or records a review. Returns its exit status: 1 for findings.
int check_misra(const MisraOptions& options);

}  // namespace canproof::host
