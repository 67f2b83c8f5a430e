// SPDX-License-Identifier: Apache-2.0
// The tables of techniques from IEC 61508 and ISO 26262 as a page of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the body of the page as markup: every row of every table with the state that the exhibits permit.
std::string standards_page(const PackInput& input, const Exhibits& exhibits);

}  // namespace canproof::host
