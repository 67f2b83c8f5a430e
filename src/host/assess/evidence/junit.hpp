// The verdicts for tools that read JUnit XML.
#pragma once

#include <string>

#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

/// All test cases, without times: the same verdicts give the same bytes.
std::string write_junit(const Evidence& evidence);

}  // namespace canproof::host
