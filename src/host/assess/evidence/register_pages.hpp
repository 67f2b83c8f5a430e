// SPDX-License-Identifier: Apache-2.0
// The pages of the evidence pack about the requirements register and the results of tests. Each function returns the
// body of a page as markup.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the manuals with their coverage and links to their pages. Also lists the conditions of use, the sections
/// without requirements and, for a manual without statements, the normative sections.
std::string sections_page(const PackInput& input);
std::string tests_page(const PackInput& input);
/// Returns the plots of the devices' behaviour.
std::string plots_page(const PackInput& input);

}  // namespace canproof::host
