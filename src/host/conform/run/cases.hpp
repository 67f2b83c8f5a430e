// SPDX-License-Identifier: Apache-2.0
// The cases of spec/conformance/ after parsing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/conform/steps/need.hpp"
#include "host/conform/steps/step.hpp"
#include "host/register/fault.hpp"

namespace canproof::host::conform {

/// The most serious effect that a case may have on the equipment.
enum class Risk { none, output, store, lss, restart };
enum class Preparation { none, reset_communication, reset_node };

struct Case {
    std::string id;
    std::string group;
    std::vector<std::string> numbers;  ///< numbers of this case in the conformance test log of CANopenNode's issue 323
    std::string shows;
    std::string section;
    std::vector<std::string> tests;
    std::vector<Need> needs;
    Risk risk{Risk::none};
    Preparation preparation{Preparation::reset_communication};
    bool allows_emcy{false};
    bool allows_boot_up{false};
    bool allows_sdo{false};
    Steps steps;
    Steps restore;
    Place place;
};

struct CaseBook {
    std::vector<Case> cases;  ///< sorted by group, within a group in the order of the files
    std::map<std::string, Procedure> procedures;
};

/// Returns the names of the groups of cases, in the order in which a run executes them.
const std::vector<std::string>& case_groups();

/// Parses all files. Adds a fault with file, line and fix for each part that cannot be parsed.
CaseBook parse_cases(const std::map<std::string, std::string>& files, Faults& faults);
/// Returns the cases that are embedded in the program. Throws std::logic_error when they are not valid.
const CaseBook& built_in_cases();

}  // namespace canproof::host::conform
