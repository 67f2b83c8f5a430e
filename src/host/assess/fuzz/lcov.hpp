// SPDX-License-Identifier: Apache-2.0
// Parses llvm-cov's lcov export: the lines and functions of the firmware that a coverage run reached.
#pragma once

#include <string>
#include <vector>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

/// Returns the files of the firmware in alphabetical order, with paths relative to the project.
std::vector<FileLines> read_lcov(const std::string& text);

}  // namespace canproof::host
