// The tables of the standards as a page.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Every row of every table with its state. Gives the markup of the body.
std::string standards_page(const PackInput& input);

}  // namespace canproof::host
