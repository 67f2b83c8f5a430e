// SPDX-License-Identifier: Apache-2.0
// Writes a run as files: HTML, JUnit, JSON, text.
#pragma once

#include <map>
#include <string>

#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

/// Returns the line of a result: `passed     sdo-device-type`, and the reason if the case did not pass.
std::string result_line(const CaseResult& one);
/// Returns the last lines of a run: the counts, and what is left to do.
std::string summary_lines(const ConformReport& report);

/// Returns every file by its path: index.html, a page for each service and for each failed case, junit.xml,
/// report.json, report.txt. The same report gives the same bytes.
std::map<std::string, std::string> report_files(const ConformReport& report);

}  // namespace canproof::host::conform
