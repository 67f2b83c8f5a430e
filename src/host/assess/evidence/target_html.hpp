// SPDX-License-Identifier: Apache-2.0
// Performance and memory on the microcontroller as a report.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns a section of the report with the results of src/target/footprint and run_suites in `build`. When they did
/// not run, the section states this.
std::string write_target_html(const std::filesystem::path& build);

}  // namespace canproof::host
