// SPDX-License-Identifier: Apache-2.0
// Runs a counterexample as a native program.
#pragma once

#include "host/prove/compile.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// The place where a counterexample is stored as an input of a fuzz target, if its harness writes one:
/// FOLDER/TARGET/NAME.
struct SeedPlace {
    std::filesystem::path folder{};  ///< folder of the corpora; empty: the input is not stored
    std::string name{};              ///< name of the input; empty: the name of the theorem
};

/// Compiles the theorem with sanitizers and runs it with the values of the counterexample. Writes the outcome to
/// `result.replay`.
void replay(Compiler& compiler, const std::filesystem::path& scratch, const SeedPlace& seeds, TheoremResult& result);

/// Returns whether the native program failed too, with the values of the counterexample.
bool is_reproduced(const TheoremResult& result);

}  // namespace canproof::host::prove
