// SPDX-License-Identifier: Apache-2.0
// Reads the measurement of llvm-cov from its export.
#pragma once

#include <filesystem>
#include <vector>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

/// How read_coverage() detects that a source has changed since the measurement: by the times of files, or not at all,
/// because the caller has already compared the contents.
enum class SourceAge { by_time, compared };

/// Reads a file that `llvm-cov export --format=text` wrote. Returns the measured files of firmware and host
/// (firmware_scope.hpp). Adds up the counts of all instantiations of a template. Throws InputError when the file is no
/// such export or measures no file of the firmware, and when a source is missing or, with SourceAge::by_time, newer
/// than the file.
std::vector<FileCoverage> read_coverage(const std::filesystem::path& file, const std::filesystem::path& root,
                                        SourceAge age = SourceAge::by_time);

}  // namespace canproof::host
