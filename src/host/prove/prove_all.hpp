// Decides all theorems of the project, in several processes at the same time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

struct ProveOptions {
    std::filesystem::path proofs{"properties/proofs"};
    std::filesystem::path generated;  ///< folder with the headers that the build generated
    std::filesystem::path scratch;    ///< folder for temporary files
    std::filesystem::path overlay{};  ///< folder with changed sources, by their path; empty: none
    std::string area{};               ///< only the proofs of the folder with this name; empty: all
    std::string theorem{};            ///< only this theorem; empty: all
    unsigned seconds{60};             ///< of processor time for one theorem; it is unknown after that
    unsigned jobs{2};                 ///< number of processes at the same time
    bool replays{true};               ///< runs each counterexample as a native program
};

/// The results of the theorems, in the order of the files and then in the order within a file. Paths are relative to
/// the project's folder, which must be the current one. Throws InputError when something does not compile or no theorem
/// fits the options.
std::vector<TheoremResult> prove_all(const ProveOptions& options);

}  // namespace canproof::host::prove
