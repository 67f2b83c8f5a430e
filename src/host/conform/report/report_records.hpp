// SPDX-License-Identifier: Apache-2.0
// Writes the results of a conformance test for other programs, as JSON and JUnit.
#pragma once

#include <string>

#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

std::string write_json(const ConformReport& report);
std::string write_junit_xml(const ConformReport& report);

}  // namespace canproof::host::conform
