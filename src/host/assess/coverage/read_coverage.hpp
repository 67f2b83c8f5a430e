// What llvm-cov measured, out of its export.
#pragma once

#include <filesystem>
#include <vector>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

/// How it is known that sources are as they were when they were measured: by the times of files, or the caller has
/// compared their contents.
enum class SourceAge { by_time, compared };

/// Reads what `llvm-cov export --format=text` wrote, for the files of the firmware, and for those of the host
/// that are judged beside it (firmware_scope.hpp). Instantiations of a template count together. Throws InputError when
/// the file is no such export or a source is missing.
std::vector<FileCoverage> read_coverage(const std::filesystem::path& file, const std::filesystem::path& root,
                                        SourceAge age = SourceAge::by_time);

}  // namespace canproof::host
