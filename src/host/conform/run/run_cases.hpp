// Runs cases against a slave, each from a known state, and puts back what they changed.
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
    std::vector<std::string> only;   ///< groups; none: all
    std::vector<std::string> cases;  ///< ids or numbers; none: all
    std::vector<std::string> skip;   ///< ids, numbers or groups
    bool allow_outputs{true};
    bool allow_store{true};
    bool allow_lss{true};
    double traffic{0.0};  ///< foreign frames all the time, per cent of the bus
    bool first_failure_ends{false};
    Duration sdo_timeout{milliseconds(1000)};
    /// Is told each result as it comes; may be empty.
    std::function<void(const CaseResult&)> progress;
};

/// A failed case runs again up to so many times on a real bus.
constexpr unsigned most_runs = 4;

/// Throws InputError when an option names no case, and when the slave does not answer at all.
ConformReport run_cases(const CaseBook& book, const ConformSheet& sheet, Target& target, const ConformOptions& options);

/// The cases that the options choose. Throws InputError for a name that is none.
std::vector<const Case*> chosen_cases(const CaseBook& book, const ConformOptions& options);

}  // namespace canproof::host::conform
