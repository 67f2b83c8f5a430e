// SPDX-License-Identifier: Apache-2.0
// The page of the evidence pack with the results of mutation: cells (values in generated tables) were altered, one at a
// time.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the body of the page as markup: each item with altered cells, and the survivors (alterations that no test
/// noticed). `input.mutation` must have a value.
std::string mutation_page(const PackInput& input);

}  // namespace canproof::host
