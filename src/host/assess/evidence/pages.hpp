// The pages of the pack that are written from the register, the verdicts, the coverage and the argument. Each gives the
// markup of its body.
#pragma once

#include <map>
#include <string>

#include "host/assess/evidence/pack.hpp"

namespace canproof::host {

using Exhibits = std::map<std::string, Exhibit>;  ///< by key

/// What the pack itself shows, that of other tools, and what a whole pack would have beside them (absent).
Exhibits exhibits_of(const PackInput& input);

/// Of the exhibit itself, for exhibits that bring no page of their own: figures, CSV tables, plots.
std::string exhibit_page(const Exhibit& exhibit);
/// Claims with their evidence and what that does not show.
std::string claims_markup(const Argument& argument, const Exhibits& exhibits);
/// A claim holds when its evidence and all claims below it hold.
bool holds(const Claim& claim, const Argument& argument, const Exhibits& exhibits);
/// With a link to its page where it has one.
std::string title_markup(const Exhibit& exhibit);

/// What is claimed, what shows it, what is open.
std::string overview_page(const PackInput& input, const Exhibits& exhibits);
/// Each item of the register with its sources, code, tests and state, to be searched.
std::string audit_page(const PackInput& input);
std::string sections_page(const PackInput& input);
std::string decisions_page(const PackInput& input);
std::string tests_page(const PackInput& input);
/// Each item whose generated cells were altered, and what survived.
std::string mutation_page(const MeasuredMutation& mutation);
std::string coverage_page(const MeasuredCoverage& coverage);
std::string argument_page(const PackInput& input, const Exhibits& exhibits);
/// The plots of the devices' behaviour.
std::string plots_page(const PackInput& input);

}  // namespace canproof::host
