// SPDX-License-Identifier: Apache-2.0
// Runs conformance cases against a slave, each from a known state, and restores what they changed.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "host/conform/link/target.hpp"
#include "host/conform/run/cases.hpp"
#include "host/conform/run/conform_report.hpp"
#include "host/conform/sheet/conform_sheet.hpp"

namespace canproof::host::conform {

struct ConformOptions {
    std::vector<std::string> only;   ///< groups of cases to run; empty: all
    std::vector<std::string> cases;  ///< ids or numbers of the cases to run; empty: all
    std::vector<std::string> skip;   ///< ids, numbers or groups of the cases to leave out
    bool allow_outputs{true};
    bool allow_store{true};
    bool allow_lss{true};
    double traffic{0.0};  ///< load by background frames during the whole run, in per cent of the bus capacity
    bool first_failure_ends{false};
    Duration sdo_timeout{milliseconds(1000)};
    /// Is called with the result of each case; may be empty.
    std::function<void(const CaseResult&)> progress;
};

/// Greatest number of runs of one case. On a real bus, a failed case runs again.
constexpr unsigned most_runs = 4;

/// Runs the cases that the options choose. Throws InputError when an option names a case or service that does not
/// exist, and when the slave does not answer at all.
ConformReport run_cases(const CaseBook& book, const ConformSheet& sheet, Target& target, const ConformOptions& options);

/// Returns the cases that the options choose. Throws InputError for an id, number or group that does not exist.
std::vector<const Case*> chosen_cases(const CaseBook& book, const ConformOptions& options);

}  // namespace canproof::host::conform
