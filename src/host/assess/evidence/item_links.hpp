// SPDX-License-Identifier: Apache-2.0
// The place of each item, decision and hazard in the evidence pack.
#pragma once

#include <string>
#include <vector>

#include "host/assess/documents/render.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns `audit-NAME.html`, the page with the items of a device or of the shared rules.
std::string audit_page_name(const Part& part);

/// Returns the places of all items, decisions and hazards of the pack: `audit-cbx-ao412.html#AO4-AOUT-002`.
ItemLinks links_of(const PackInput& input);

/// Returns a link to the item with this id as markup; returns the id without a link for an item that has no place in
/// this pack.
std::string link_to(const ItemLinks& links, const std::string& id);
/// Returns the links of several items with spaces between them.
std::string link_to_each(const ItemLinks& links, const std::vector<std::string>& ids);

}  // namespace canproof::host
