// Performance and memory on the microcontroller, for people.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// A section of the report from what src/target/footprint and run_suites left in `build`; says so when they did not
/// run.
std::string write_target_html(const std::filesystem::path& build);

}  // namespace canproof::host
