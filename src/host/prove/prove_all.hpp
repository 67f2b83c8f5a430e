// All theorems of the project, some processes beside each other.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/base/shard.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

struct ProveOptions {
    std::filesystem::path proofs{"properties/proofs"};
    std::filesystem::path generated;  ///< headers that the build wrote
    std::filesystem::path scratch;    ///< folder for what is compiled
    std::filesystem::path overlay{};  ///< changed sources, by their path; empty: none
    std::string area{};               ///< only proofs of this folder; empty: all
    std::string theorem{};            ///< only this one; empty: all
    std::optional<Shard> shard{};     ///< only this part of the theorems that fit
    unsigned seconds{60};             ///< of processor time for one theorem; it is unknown after that
    unsigned jobs{2};                 ///< processes at once
    bool replays{true};               ///< runs each counterexample natively
};

/// In the order of files and, within one, of theorems. Paths are relative to the project's folder, the current one.
/// Throws InputError when something does not compile or nothing fits the options.
std::vector<TheoremResult> prove_all(const ProveOptions& options);

}  // namespace canproof::host::prove
