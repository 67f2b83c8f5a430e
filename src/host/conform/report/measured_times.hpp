// SPDX-License-Identifier: Apache-2.0
// Measurements of a run, in words and drawn: the load of the bus, and times with what the cases accept of them.
#pragma once

#include <map>
#include <string>

#include "host/conform/link/measured.hpp"
#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

/// Returns a text such as `3.1 % on average, 47.0 % in the busiest second; 812 frames, 400 of them from the tester, 0
/// error frames, 0 lost`.
std::string load_words(const ConformReport& report);

/// Times with the same meaning in each case, over all cases: `SDO answer` and `boot-up`.
std::map<std::string, Measured> times_of_all(const ConformReport& report);

/// Returns a histogram as an SVG element. A dashed line marks each accepted limit that lies in its range.
std::string draw_times(const Measured& measured);

/// Returns one row for each kind of time; empty when there are no times.
std::string times_table(const std::map<std::string, Measured>& times);

}  // namespace canproof::host::conform
