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
    std::filesystem::path generated;  ///< headers that the build wrote
    std::filesystem::path scratch;    ///< folder for what is compiled
    std::filesystem::path overlay{};  ///< changed sources, by their path; empty: none
    std::string area{};               ///< only proofs of this folder; empty: all
    std::string theorem{};            ///< only this one; empty: all
    std::optional<Shard> shard{};     ///< only this part of the selected theorems
    unsigned seconds{60};             ///< of processor time for one theorem; it is unknown after that
    unsigned jobs{2};                 ///< number of processes at the same time
    bool replays{true};               ///< runs each counterexample as a native program
    SeedPlace seeds{};                ///< where that program writes it as an input of a fuzz target
};

/// Returns the results of the theorems, in the order of the files and then in the order within a file. Paths are
/// relative to the project's folder, which must be the current one. Throws InputError when a source does not compile or
/// no theorem fits the options.
std::vector<TheoremResult> prove_all(const ProveOptions& options);

}  // namespace canproof::host::prove
