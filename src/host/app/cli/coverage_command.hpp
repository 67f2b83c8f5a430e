// SPDX-License-Identifier: Apache-2.0
// `canproof coverage`: lists the places in the firmware, and in the host code for buses and replay, that no test
// reaches.
#pragma once

#include <string>

namespace canproof::host {

struct CoverageOptions {
    std::string root{"."};
    std::string measured{"build/coverage/coverage.json"};  ///< file that `llvm-cov export` wrote
    std::string cobertura;                                 ///< Cobertura XML file to write; empty: none
    bool json{false};                                      ///< JSON instead of lines
    bool records_only{false};  ///< checks only whether the sources still contain the code of each recorded reason
};

/// Prints the places that no test reaches and that have no recorded reason. Returns the exit status: 1 when there is
/// such a place, when the code that a recorded reason concerns is gone, or when MC/DC is too low.
int check_coverage(const CoverageOptions& options);

}  // namespace canproof::host
