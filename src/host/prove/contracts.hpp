// SPDX-License-Identifier: Apache-2.0
// Decides which theorems count as proven, although they use contracts of functions that other theorems prove.
#pragma once

#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Makes each proven theorem unknown that uses a contract which no proven theorem shows, or which it would show itself,
/// directly or through others. When `has_all` is false, some theorems were not selected: the contracts that they prove
/// then become assumptions of the theorems that use them.
void check_contracts(std::vector<TheoremResult>& results, bool has_all);

}  // namespace canproof::host::prove
