// SPDX-License-Identifier: Apache-2.0
// The measurements of a conformance test as text and drawings: the load of the bus, and times with the limits that the
// cases accept.
#pragma once

#include <map>
#include <string>

#include "host/conform/link/measured.hpp"
#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

/// Returns the bus load as text. The text consists of the mean load, the load of the busiest second, and the numbers of
/// all frames, of the tester's frames, of error frames and of lost frames. If the bit rate is not known, the number of
/// bits replaces the loads.
std::string load_words(const ConformReport& report);

/// Returns the times of all cases, merged for each of two kinds: `SDO answer` and `boot-up`. Only these two have the
/// same meaning in every case.
std::map<std::string, Measured> times_of_all(const ConformReport& report);

/// Returns a histogram as an SVG element. A dashed line marks each limit above 0 that is inside the range of the
/// histogram. Returns an empty text when there are no times.
std::string draw_times(const Measured& measured);

/// Returns an HTML table with one row for each name in `times`; an empty text when there are no times.
std::string times_table(const std::map<std::string, Measured>& times);

}  // namespace canproof::host::conform
