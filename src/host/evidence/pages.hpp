// The pages of the pack that are written from the register, the verdicts, the coverage and the argument. Each gives the
// markup of its body.
#pragma once

#include <map>
#include <string>

#include "host/evidence/pack.hpp"

namespace canproof::host {

using Exhibits = std::map<std::string, Exhibit>;  ///< by key

/// What is claimed, what shows it, what is open.
std::string overview_page(const PackInput& input, const Exhibits& exhibits);
/// Each item of the register with its sources, code, tests and state, to be searched.
std::string audit_page(const PackInput& input);
std::string sections_page(const PackInput& input);
std::string decisions_page(const PackInput& input);
std::string tests_page(const PackInput& input);
std::string coverage_page(const MeasuredCoverage& coverage);
std::string argument_page(const PackInput& input, const Exhibits& exhibits);
/// The plots of the devices' behaviour.
std::string plots_page(const PackInput& input);

}  // namespace canproof::host
