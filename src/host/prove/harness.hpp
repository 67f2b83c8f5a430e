// SPDX-License-Identifier: Apache-2.0
// Carries out the functions that a harness calls and that properties/proofs/support/proof.hpp declares.
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

/// Carries out the called function, and returns its effect on the path.
HarnessEffect call_harness(Proof& proof, Globals& globals, State& state, HarnessCall& call);

}  // namespace canproof::host::prove
