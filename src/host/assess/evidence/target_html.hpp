// SPDX-License-Identifier: Apache-2.0
// The section of the report about performance and memory on the microcontroller.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns a section of the report with the results that src/target/footprint and run_suites wrote to `build`. Without
/// footprint.json and suites.json, the section states that nothing was measured.
std::string write_target_html(const std::filesystem::path& build);

}  // namespace canproof::host
