// SPDX-License-Identifier: Apache-2.0
// The functions that a harness calls and the prover carries out itself; properties/proofs/support/proof.hpp declares
// them.
#pragma once

#include <string>

#include "host/prove/globals.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

enum class HarnessEffect {
    none,       ///< the function is not one of the harness functions
    goes_on,    ///< the function was executed; the path continues
    path_ends,  ///< an assumption excludes this path
};

struct HarnessCall {
    std::string function;
    Value arguments;
    std::string where;
    Value result{};
};

/// Carries out the function.
HarnessEffect call_harness(Proof& proof, Globals& globals, State& state, HarnessCall& call);

}  // namespace canproof::host::prove
