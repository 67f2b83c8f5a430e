// SPDX-License-Identifier: Apache-2.0
// Runs a counterexample as a native program.
#pragma once

#include "host/prove/compile.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Compiles the theorem with sanitizers, runs it with the values of the counterexample, and writes into `result` what
/// happened.
void replay(Compiler& compiler, const std::filesystem::path& scratch, TheoremResult& result);

/// True when the native program failed as well.
bool is_reproduced(const TheoremResult& result);

}  // namespace canproof::host::prove
