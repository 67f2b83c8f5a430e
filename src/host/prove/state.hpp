// SPDX-License-Identifier: Apache-2.0
// The state of an execution: the conditions of its path, and the contents of the memory.
#pragma once

#include "host/prove/memory.hpp"
#include "host/prove/solver.hpp"

namespace canproof::host::prove {

struct State {
    std::vector<Term> path;
    Memory memory;
    double paths{1.0};  ///< number of paths through the program that are merged in this state
};

/// The result of merging the conditions of two paths. `first_holds` is true on the first path and false on the second,
/// and so chooses between their values. `path` contains the conditions of the merged path.
struct Meeting {
    Term first_holds;
    std::vector<Term> path;
    std::optional<Term> either;  ///< condition that one of the two paths is taken; empty if `path` implies it
};
Meeting meet(z3::context& context, const std::vector<Term>& first, const std::vector<Term>& second);

/// Merges `second` into `first`. Returns the condition under which values that are not in memory come from `first`.
Term merge(Solver& solver, const Objects& objects, State& first, const State& second);

}  // namespace canproof::host::prove
