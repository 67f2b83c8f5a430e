// The page of one manual: its structure, coloured by what is shown of it.
#pragma once

#include <string>
#include <vector>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// What is shown of a section, as a word: `proven`, `not proven` (covered by items, and one of them is not shown),
/// `uncovered` (a statement that nothing covers, or no statement), `explained` (each statement has a reason instead of
/// an item), `informative`, `condition of use`. In a manual without statements the items that have the section as
/// their source count.
std::string section_state(const Section& section, const std::vector<const AuditedStatement*>& statements,
                          const std::vector<std::string>& item_states, bool counts_by_section);

/// `manual-cbx-ao412.html`
std::string manual_page_name(const Part& part);

/// Markup of the page's body: a tile and a row for each section, with our statements and links to their items. It has
/// none of the manual's own text.
std::string manual_page(const PackInput& input, const PartAudit& audit, const Manual& manual);

}  // namespace canproof::host
