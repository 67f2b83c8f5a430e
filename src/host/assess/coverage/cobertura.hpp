// Coverage for build servers.
#pragma once

#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

/// The firmware's in the form of Cobertura, which build servers read.
std::string write_cobertura(const std::vector<FileCoverage>& files);

}  // namespace canproof::host
