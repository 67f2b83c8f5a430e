// SPDX-License-Identifier: Apache-2.0
// The first page of the pack: claims, their evidence, and open points.
#pragma once

#include <string>

#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the title of an exhibit (the result of a tool) as markup, with a link to its page if it has one.
std::string title_markup(const Exhibit& exhibit);
/// Returns the body of the page as markup.
std::string overview_page(const PackInput& input, const Exhibits& exhibits);

}  // namespace canproof::host
