// SPDX-License-Identifier: Apache-2.0
// Writes the results of a conformance test as HTML pages in the style of the evidence pack.
#pragma once

#include <map>
#include <string>

#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

/// Returns pages by their paths: index.html, GROUP.html for each group of cases in the report, and case-ID.html for
/// each case that ran and did not pass.
std::map<std::string, std::string> report_pages(const ConformReport& report);

}  // namespace canproof::host::conform
