// SPDX-License-Identifier: Apache-2.0
// Writes the results of a conformance test as files: HTML, JUnit, JSON, text.
#pragma once

#include <map>
#include <string>

#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

/// Returns the line of a result: `passed     sdo        sdo-device-type`. If the case did not pass, adds the reason
/// and, on a second line, the step.
std::string result_line(const CaseResult& one);
/// Returns the last lines of a run: the counts, the bus load, the times, wrong behaviour before the first case, and the
/// dictionary entries that could not be restored.
std::string summary_lines(const ConformReport& report);

/// Returns every file by its path: the pages of report_pages(), junit.xml, report.json, report.txt. The same report
/// gives the same bytes.
std::map<std::string, std::string> report_files(const ConformReport& report);

}  // namespace canproof::host::conform
