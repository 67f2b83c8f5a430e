// Lines and functions of the firmware that a coverage run reached, from llvm-cov's lcov export.
#pragma once

#include <string>
#include <vector>

#include "host/assess/fuzz/campaign_state.hpp"

namespace canproof::host {

/// Only files of the firmware, in alphabetical order, with their paths in this project.
std::vector<FileLines> read_lcov(const std::string& text);

}  // namespace canproof::host
