// SPDX-License-Identifier: Apache-2.0
// The page of the evidence pack about one manual: its sections, coloured by their state.
#pragma once

#include <string>
#include <vector>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the state of a section:
/// - `shown`: items cover the section, and the audit's verdict on each of them is shown;
/// - `not shown`: items cover the section, and the audit's verdict on at least one of them is not shown;
/// - `uncovered`: the section has no statement, or a statement with neither an item nor a reason;
/// - `explained`: each statement of the section has a reason instead of an item;
/// - `informative` or `condition of use`: the section is not normative, and each of its statements has a reason.
/// In a manual without statements, the items that name the section as their source decide.
std::string section_state(const Section& section, const std::vector<const AuditedStatement*>& statements,
                          const std::vector<std::string>& item_states, bool counts_by_section);

/// Returns the name of the page's file: `manual-cbx-ao412.html`.
std::string manual_page_name(const Part& part);

/// Returns the body of the page as markup. Each section has a tile, and a row with the project's statements and links
/// to their items. The page contains no text of the manual.
std::string manual_page(const PackInput& input, const PartAudit& audit, const Manual& manual);

}  // namespace canproof::host
