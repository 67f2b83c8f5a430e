// SPDX-License-Identifier: Apache-2.0
// Decides all theorems of the project, in several processes at the same time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/base/shard.hpp"
#include "host/prove/replay.hpp"

namespace canproof::host::prove {

struct ProveOptions {
    std::filesystem::path proofs{"properties/proofs"};
    std::filesystem::path generated;  ///< folder with the headers that the build wrote
    std::filesystem::path scratch;    ///< folder for compiled files
    std::filesystem::path overlay{};  ///< folder with changed sources, each at its path in the project; empty: no
                                      ///< changes
    std::string area{};               ///< folder of the proofs to decide; empty: all folders
    bool takes_long{false};           ///< whether folders that end in `_long` belong to all folders
    std::string theorem{};            ///< name of the theorem to decide; empty: all theorems
    std::optional<Shard> shard{};     ///< decides only this part of the selected theorems
    unsigned seconds{120};            ///< processor time in seconds for one theorem; a theorem that needs more is
                                      ///< unknown
    unsigned jobs{2};                 ///< number of processes at the same time
    std::filesystem::path kept{};     ///< folder with verdicts of earlier runs; empty: every theorem is decided
    bool replays{true};               ///< whether each counterexample also runs as a native program
    SeedPlace seeds{};  ///< where the native program writes the counterexample as an input of a fuzz target
};

/// Decides the selected theorems. Returns their results in the order of the files; the theorems of one file stay in
/// their order. Paths are relative to the project's folder, which must be the current folder. Throws InputError when a
/// source does not compile or no theorem matches the options.
std::vector<TheoremResult> prove_all(const ProveOptions& options);
/// Returns the files of theorems that prove_all() leaves out because their proofs take long; none when the options
/// select a folder or a theorem.
std::vector<std::string> long_files_left_out(const ProveOptions& options);

}  // namespace canproof::host::prove
