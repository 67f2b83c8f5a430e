// SPDX-License-Identifier: Apache-2.0
// The results of the tests as JUnit XML, for tools that read this format.
#pragma once

#include <string>

#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// Returns all test cases by suite, with result, duration, source, and the items that each test case verifies.
std::string write_junit(const Evidence& evidence);

}  // namespace canproof::host
