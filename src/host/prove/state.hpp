// Where an execution stands: what is true on its path, and what memory holds.
#pragma once

#include "host/prove/memory.hpp"

namespace canproof::host::prove {

struct State {
    std::vector<Term> path;
    Memory memory;
    double paths{1.0};  ///< how many paths through the program it stands for
};

/// How to choose between two states that meet: true on the path of the first, false on that of the second.
struct Meeting {
    Term first_holds;
    std::vector<Term> path;
};
Meeting meet(z3::context& context, const std::vector<Term>& first, const std::vector<Term>& second);

/// Makes `first` stand for both; what held on `first` alone is chosen by the condition that comes back.
Term merge(z3::context& context, const Objects& objects, State& first, const State& second);

}  // namespace canproof::host::prove
