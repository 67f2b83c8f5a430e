// The argument as a page of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Claims with their evidence and what that does not show, as markup.
std::string claims_markup(const Argument& argument, const Exhibits& exhibits);
/// A claim holds when its evidence and all claims below it hold.
bool holds(const Claim& claim, const Argument& argument, const Exhibits& exhibits);
/// Markup of the page's body.
std::string argument_page(const PackInput& input, const Exhibits& exhibits);

}  // namespace canproof::host
