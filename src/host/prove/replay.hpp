// SPDX-License-Identifier: Apache-2.0
// Runs a counterexample as a native program.
#pragma once

#include "host/prove/compile.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Where a counterexample goes as an input of a fuzz target, when its harness offers one: FOLDER/TARGET/NAME.
struct SeedPlace {
    std::filesystem::path folder{};  ///< of corpora; empty: nowhere
    std::string name{};              ///< empty: the name of the theorem
};

/// Compiles the theorem with sanitizers, runs it with the values of the counterexample, and writes into `result` what
/// happened.
void replay(Compiler& compiler, const std::filesystem::path& scratch, const SeedPlace& seeds, TheoremResult& result);

/// True when the native program failed as well.
bool is_reproduced(const TheoremResult& result);

}  // namespace canproof::host::prove
