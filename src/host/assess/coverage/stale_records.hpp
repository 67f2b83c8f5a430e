// Records whose code has moved on.
#pragma once

#include <filesystem>
#include <vector>

#include "host/assess/coverage/coverage_records.hpp"

namespace canproof::host {

/// The records whose text no longer stands in the sources that they name, below `root`; nothing needs to be measured.
std::vector<CoverageRecord> stale_records(const std::vector<CoverageRecord>& records,
                                          const std::filesystem::path& root);

}  // namespace canproof::host
