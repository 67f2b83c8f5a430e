// The cases of spec/conformance/, read.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/conform/steps/need.hpp"
#include "host/conform/steps/step.hpp"
#include "host/register/fault.hpp"

namespace canproof::host::conform {

/// What a case may do to the equipment.
enum class Risk { none, output, store, lss, restart };
enum class Preparation { none, reset_communication, reset_node };

struct Case {
    std::string id;
    std::string group;
    std::vector<std::string> numbers;  ///< of the public transcript
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
    std::vector<Case> cases;  ///< by group, then as the files have them
    std::map<std::string, Procedure> procedures;
};

/// The services in the order of a run.
const std::vector<std::string>& case_groups();

/// Everything that can be read; what cannot is a fault with file, line and fix.
CaseBook parse_cases(const std::map<std::string, std::string>& files, Faults& faults);
/// The cases that the program carries. Throws std::logic_error when they are not sound.
const CaseBook& built_in_cases();

}  // namespace canproof::host::conform
