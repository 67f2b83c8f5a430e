// `canproof spec review`: items that were read with their code and tests.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct ReviewOptions {
    std::string spec{"spec"};           ///< below the project's folder
    std::vector<std::string> subjects;  ///< ids or devices
    bool all{false};
    std::string by;
    std::string role;      ///< author (of the change) or independent
    std::string verdicts;  ///< folder of test results; empty: the newest of the project
    bool mark{false};      ///< the marks of code and tests alone, of reviews that stay
    bool wording{false};   ///< the items alone were read; their code and tests are marked as they are
    std::string date;      ///< 2026-11-21; empty: today
};

/// Writes reviews.toml of each part. Returns the exit status.
int review_spec(const ReviewOptions& options);

}  // namespace canproof::host
