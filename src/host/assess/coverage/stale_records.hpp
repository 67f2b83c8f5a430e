// SPDX-License-Identifier: Apache-2.0
// Finds the records of reports/coverage.toml whose code has changed.
#pragma once

#include <filesystem>
#include <vector>

#include "host/assess/coverage/coverage_records.hpp"

namespace canproof::host {

/// Returns the records whose text no longer occurs in the sources that they name, below `root`. Needs no measurement.
std::vector<CoverageRecord> stale_records(const std::vector<CoverageRecord>& records,
                                          const std::filesystem::path& root);

}  // namespace canproof::host
