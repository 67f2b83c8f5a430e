// SPDX-License-Identifier: Apache-2.0
// Structural coverage as JSON. It includes MC/DC, which the Cobertura format does not support.
#pragma once

#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/coverage/coverage_records.hpp"

namespace canproof::host {

/// Returns JSON with lines, branches and MC/DC conditions of the firmware, in total and by file. It lists every place
/// that no run reached, with its recorded reason, and the verdict.
std::string coverage_json(const std::vector<FileCoverage>& files, const CoverageVerdict& verdict);

}  // namespace canproof::host
