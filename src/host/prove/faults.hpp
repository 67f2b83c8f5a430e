// SPDX-License-Identifier: Apache-2.0
// Seeded faults: small wrong changes of real functions, made on purpose. For each, one theorem must not be proven. This
// shows that the prover finds faults.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/prove/prove_all.hpp"

namespace canproof::host::prove {

/// A seeded fault: one replacement of text in one source.
struct Fault {
    std::string name;
    std::string file;
    std::string from;  ///< text to replace; the source must contain it exactly once
    std::string to;
    std::string theorem;  ///< name of the theorem that must not be proven
    /// `refuted`; `unknown` for a theorem with an invariant or a contract, which is never refuted
    Verdict verdict{Verdict::refuted};
};

/// Reads the table of faults from a TOML file. Throws InputError when the file does not contain a valid fault.
std::vector<Fault> read_faults(const std::filesystem::path& table);

/// Tries each fault whose number, counted from 0, is a multiple of `every`. Its theorem must have the verdict that the
/// fault names. The counterexample of a refuted theorem must also fail in the native program. Prints two lines for each
/// fault. Returns 0 when every tried fault meets both conditions, otherwise 1. Without replays, the second
/// condition is not checked.
int try_faults(const std::filesystem::path& table, unsigned every, const ProveOptions& options);

}  // namespace canproof::host::prove
