// `canproof misra`: MISRA C++:2023 over the firmware.
#pragma once

#include <string>

namespace canproof::host {

struct MisraOptions {
    std::string root{"."};
    std::string build;        ///< folder with a built firmware; build/release or build/debug without it
    std::string out;          ///< folder for misra.sarif, compliance.md and misra.html; BUILD/misra without it
    std::string review_file;  ///< instead of a check: record that `reviewer` judged this file for `review_rule`
    std::string review_rule;
    std::string reviewer;
    std::string judgement;
};

/// Starts misra/run; 1 when it finds something. Returns the exit status.
int check_misra(const MisraOptions& options);

}  // namespace canproof::host
