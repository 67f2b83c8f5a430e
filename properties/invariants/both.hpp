// SPDX-License-Identifier: Apache-2.0
// A conjunction without a branch.
#pragma once

namespace canproof {

/// Returns `a && b` without a branch. For the operator &&, the prover would follow a path for each condition, and a
/// fuzz target would count an edge for each.
inline bool both(const bool a, const bool b) noexcept {
    return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0U;
}

}  // namespace canproof
