// SPDX-License-Identifier: Apache-2.0
// Parses the lcov export of llvm-cov: the lines and functions of the firmware that the runs reached.
#pragma once

#include <string>
#include <vector>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

/// Returns the files of the firmware in alphabetical order, with paths relative to the project.
std::vector<FileLines> read_lcov(const std::string& text);

}  // namespace canproof::host
