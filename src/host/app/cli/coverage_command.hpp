// SPDX-License-Identifier: Apache-2.0
// Checks the records against the sources, without a measurement. Returns the exit status: 1 for a record that matches
// no place.
#pragma once

#include <string>

namespace canproof::host {

struct CoverageOptions {
    std::string root{"."};
    std::string measured{"build/coverage/coverage.json"};  ///< file that `llvm-cov export` wrote
    std::string cobertura;                                 ///< file to write; empty: none
    bool json{false};                                      ///< JSON instead of lines
    bool records_only{false};                              ///< no measurement: checks the records against the sources
};

/// Prints the places that no test reaches. Returns the exit status: 1 when one has no reason.
int check_coverage(const CoverageOptions& options);

}  // namespace canproof::host
