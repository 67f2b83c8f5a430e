// The page of an exhibit that brings none.
#pragma once

#include <string>

#include "host/assess/evidence/exhibit.hpp"

namespace canproof::host {

/// Markup of the body: figures, CSV tables, plots.
std::string exhibit_page(const Exhibit& exhibit);

}  // namespace canproof::host
