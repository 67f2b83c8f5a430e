// `canproof coverage`: what no test reached in the firmware.
#pragma once

#include <string>

namespace canproof::host {

struct CoverageOptions {
    std::string root{"."};
    std::string measured{"build/coverage/coverage.json"};  ///< what `llvm-cov export` wrote
    std::string cobertura;                                 ///< file to write, none when empty
    bool json{false};                                      ///< JSON instead of lines
    bool records_only{false};                              ///< nothing measured: records against the sources
};

/// 1 when a gap has no reason. Returns the exit status.
int check_coverage(const CoverageOptions& options);

}  // namespace canproof::host
