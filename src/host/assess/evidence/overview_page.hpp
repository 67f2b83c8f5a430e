// The first page of the pack: what is claimed, what shows it, what is open.
#pragma once

#include <string>

#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Of an exhibit, as markup: with a link to its page where it has one.
std::string title_markup(const Exhibit& exhibit);
/// Markup of the page's body.
std::string overview_page(const PackInput& input, const Exhibits& exhibits);

}  // namespace canproof::host
