// SPDX-License-Identifier: Apache-2.0
// The section of the report about faults of the processor: which part fails in which way, and what notices it (FMEDA).
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns the section from the files that src/target/faults/run wrote to the folder `faults` of a build: NAME.json,
/// and NAME-without.json for the run without self-tests. Without files, the section states that nothing was measured.
std::string write_fault_campaign_html(const std::filesystem::path& build);

}  // namespace canproof::host
