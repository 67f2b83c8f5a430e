// SPDX-License-Identifier: Apache-2.0
// The state of an execution: what is true on its path, and what memory holds.
#pragma once

#include "host/prove/memory.hpp"

namespace canproof::host::prove {

struct State {
    std::vector<Term> path;
    Memory memory;
    double paths{1.0};  ///< the number of paths through the program that are merged in it
};

/// The conditions that two paths have when they merge. `first_holds` is true on the first path and false on the second;
/// it chooses between their values. `path` is the condition of the merged path.
struct Meeting {
    Term first_holds;
    std::vector<Term> path;
};
Meeting meet(z3::context& context, const std::vector<Term>& first, const std::vector<Term>& second);

/// Merges `second` into `first`. Returns the condition that chooses the values of `first`, for values that are not in
/// memory.
Term merge(z3::context& context, const Objects& objects, State& first, const State& second);

}  // namespace canproof::host::prove
