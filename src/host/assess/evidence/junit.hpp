// SPDX-License-Identifier: Apache-2.0
// The verdicts as JUnit XML, for tools that read it.
#pragma once

#include <string>

#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// Returns all test cases without their durations, so that the same verdicts give the same bytes.
std::string write_junit(const Evidence& evidence);

}  // namespace canproof::host
