// SPDX-License-Identifier: Apache-2.0
// The page of the evidence pack with the decisions.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the body of the page as markup: the decisions by device and topic; a reader can search them and filter them
/// by severity.
std::string decisions_page(const PackInput& input);

}  // namespace canproof::host
