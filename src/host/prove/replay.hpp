// A counterexample, run natively.
#pragma once

#include "host/prove/compile.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Compiles the theorem under sanitizers, runs it with the counterexample's values and notes in the result what
/// happened.
void replay(Compiler& compiler, const std::filesystem::path& scratch, TheoremResult& result);

/// Whether the native program failed as well.
bool is_reproduced(const TheoremResult& result);

}  // namespace canproof::host::prove
