// SPDX-License-Identifier: Apache-2.0
// The results of altering generated cells as a page of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the body of the page as markup: each item with altered cells, and the survivors. `input.mutation` must have
/// a value.
std::string mutation_page(const PackInput& input);

}  // namespace canproof::host
