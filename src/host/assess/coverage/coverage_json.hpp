// Structural coverage as data, MC/DC included, which Cobertura has no place for.
#pragma once

#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/coverage/coverage_records.hpp"

namespace canproof::host {

/// JSON: lines, branches and MC/DC conditions of the firmware, in all and of each file; every place that no run
/// reached, with the reason on record; whether the verdict holds.
std::string coverage_json(const std::vector<FileCoverage>& files, const CoverageVerdict& verdict);

}  // namespace canproof::host
