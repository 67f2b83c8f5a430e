// SPDX-License-Identifier: Apache-2.0
// Carries out LLVM's intrinsics, and the few functions of the C library that compilers insert.
#pragma once

#include <llvm/IR/InstrTypes.h>

#include "host/prove/globals.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

enum class CallEffect {
    none,       ///< the function is not modelled here
    goes_on,    ///< the function was executed; `result` contains its value
    path_ends,  ///< the path does not continue after the function
};

CallEffect call_intrinsic(Proof& proof, State& state, const llvm::CallBase& call, const Value& arguments,
                          Value& result);

}  // namespace canproof::host::prove
