// SPDX-License-Identifier: Apache-2.0
// `canproof spec review`: records that items of the requirements register were read with their code and tests.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct ReviewOptions {
    std::string spec{"spec"};           ///< folder of the requirements register; its parent is the project's folder
    std::vector<std::string> subjects;  ///< ids of items or sections, or names of devices
    bool all{false};
    std::string by;
    std::string role;      ///< author (of the change) or independent
    std::string verdicts;  ///< folder of test results; empty: the newest of the project
    /// computes the review marks (hashes of code and tests) of existing reviews again, and adds no review
    bool mark{false};
    /// records that the reader has read only the text of the items; also records the hashes of the present code and
    /// tests
    bool wording{false};
    std::string date;  ///< date of the review, YYYY-MM-DD; empty: today
};

/// Writes reviews.toml of each device (or of the shared rules) that has a selected item. Returns the exit status.
int review_spec(const ReviewOptions& options);

}  // namespace canproof::host
