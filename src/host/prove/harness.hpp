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

/// Lets the bytes at an address have any values, and returns these. Bytes that are part of a stored address keep their
/// values. The bytes must be inside one object, at a constant offset. Throws Unknown when they are not.
Input open_state(Proof& proof, State& state, const Term& address, std::uint64_t bytes, const std::string& where);

/// Carries out the called function, and returns its effect on the path.
HarnessEffect call_harness(Proof& proof, Globals& globals, State& state, HarnessCall& call);

}  // namespace canproof::host::prove
