// SPDX-License-Identifier: Apache-2.0
// `canproof spec review`: records that items were read with their code and tests.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct ReviewOptions {
    std::string spec{"spec"};           ///< folder of the register; its parent is the project's folder
    std::vector<std::string> subjects;  ///< ids or devices
    bool all{false};
    std::string by;
    std::string role;      ///< author (of the change) or independent
    std::string verdicts;  ///< folder of test results; empty: the newest of the project
    bool mark{false};      ///< updates the marks of code and tests in existing reviews and adds no review
    /// records that only the text of the items was read; marks the present code and tests, as `mark` does
    bool wording{false};
    std::string date;  ///< YYYY-MM-DD; empty: today
};

/// Writes reviews.toml of each selected part. Returns the exit status.
int review_spec(const ReviewOptions& options);

}  // namespace canproof::host
