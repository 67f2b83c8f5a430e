// SPDX-License-Identifier: Apache-2.0
// Seeded faults: small wrong changes of real functions, made on purpose. For each, one theorem must be refuted; this
// shows that the prover finds faults.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/prove/prove_all.hpp"

namespace canproof::host::prove {

/// A fault: one textual replacement in one source.
struct Fault {
    std::string name;
    std::string file;
    std::string from;  ///< the text to replace; the file must hold it exactly once
    std::string to;
    std::string theorem;  ///< the theorem that must be refuted
};

/// Reads the table of faults from a TOML file. Throws InputError.
std::vector<Fault> read_faults(const std::filesystem::path& table);

/// Tries every `every`-th fault: is its theorem refuted, and does the counterexample also fail in the native program?
/// Prints two lines for each fault. Returns 0 when both are true for all tried faults (without replays, when all
/// theorems are refuted), otherwise 1.
int try_faults(const std::filesystem::path& table, unsigned every, const ProveOptions& options);

}  // namespace canproof::host::prove
