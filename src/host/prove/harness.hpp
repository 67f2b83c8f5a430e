// The functions that a proof's harness calls and the prover answers: properties/proofs/support/proof.hpp declares them.
#pragma once

#include <string>

#include "host/prove/globals.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

enum class HarnessEffect {
    none,       ///< the function is none of the harness
    goes_on,    ///< done
    path_ends,  ///< an assumption excludes this path
};

struct HarnessCall {
    std::string function;
    Value arguments;
    std::string where;
    Value result{};
};

/// Does what the function means.
HarnessEffect call_harness(Proof& proof, Globals& globals, State& state, HarnessCall& call);

}  // namespace canproof::host::prove
