// A run as files: HTML, JUnit, JSON, text.
#pragma once

#include <map>
#include <string>

#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

/// `passed     sdo-device-type`, with the reason behind it when it did not pass.
std::string result_line(const CaseResult& one);
/// The last lines of a run: counts and what is left to do.
std::string summary_lines(const ConformReport& report);

/// Every file by its path: index.html, a page for each service and for each case that failed, junit.xml, report.json,
/// report.txt. The same report gives the same bytes.
std::map<std::string, std::string> report_files(const ConformReport& report);

}  // namespace canproof::host::conform
