// SPDX-License-Identifier: Apache-2.0
// The generated page of an exhibit that has no page of its own.
#pragma once

#include <string>

#include "host/assess/evidence/exhibit.hpp"

namespace canproof::host {

/// Returns the body of the page as markup: figures, CSV tables, plots.
std::string exhibit_page(const Exhibit& exhibit);

}  // namespace canproof::host
