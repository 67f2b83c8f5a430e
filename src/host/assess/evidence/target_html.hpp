// SPDX-License-Identifier: Apache-2.0
// Performance and memory on the microcontroller as a report.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns a section of the report with the results that src/target/footprint and run_suites wrote to `build`. Without
/// results, the section says that they did not run.
std::string write_target_html(const std::filesystem::path& build);

}  // namespace canproof::host
