// SPDX-License-Identifier: Apache-2.0
// Compares unsigned numbers. Many comparisons of positions in memory need no solver: the two numbers are sums with
// common summands, and neither sum can overflow.
#pragma once

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// Returns the truth value a <= b of two unsigned numbers of equal width. It is a constant where the ranges of their
/// summands decide it.
Term at_most(const Term& a, const Term& b);
/// Returns the truth value a < b in the same way.
Term less(const Term& a, const Term& b);

}  // namespace canproof::host::prove
