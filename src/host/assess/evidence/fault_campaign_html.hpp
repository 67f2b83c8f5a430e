// SPDX-License-Identifier: Apache-2.0
// The section of the report about injected faults of the processor: the failing part, the way in which it fails, and
// the mechanism that detects the fault (FMEDA).
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns the section from the files that src/target/faults/run wrote to the folder `faults` of a build: NAME.json,
/// and NAME-without.json for the run without self-tests. Without files, the section states that nothing was measured.
std::string write_fault_campaign_html(const std::filesystem::path& build);

}  // namespace canproof::host
