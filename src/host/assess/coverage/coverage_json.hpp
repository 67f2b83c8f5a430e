// SPDX-License-Identifier: Apache-2.0
// Structural coverage as JSON. It includes MC/DC, which the Cobertura format does not support.
#pragma once

#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/coverage/coverage_records.hpp"

namespace canproof::host {

/// Returns JSON with lines, branches and MC/DC conditions of the firmware, in total and by file, and with the verdict.
/// Lists each coverage gap in `verdict` with its recorded reason, if there is one. These gaps include MC/DC conditions
/// of the host's buses and replay.
std::string coverage_json(const std::vector<FileCoverage>& files, const CoverageVerdict& verdict);

}  // namespace canproof::host
