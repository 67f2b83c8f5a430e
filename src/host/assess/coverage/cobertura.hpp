// SPDX-License-Identifier: Apache-2.0
// Coverage in the Cobertura format for build servers.
#pragma once

#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

/// Returns the coverage of the firmware in the Cobertura format.
std::string write_cobertura(const std::vector<FileCoverage>& files);

}  // namespace canproof::host
