// Seeded faults: small changes of real functions, each of which some theorem must refute.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/prove/prove_all.hpp"

namespace canproof::host::prove {

/// One textual replacement in one source.
struct Fault {
    std::string name;
    std::string file;
    std::string from;  ///< stands there exactly once
    std::string to;
    std::string theorem;  ///< that refutes it
};

/// Reads the table. Throws InputError.
std::vector<Fault> read_faults(const std::filesystem::path& table);

/// Tries each `every`-th fault: whether its theorem is refuted, and the counterexample fails natively too. Prints a
/// line for each. 0 when all are, else 1.
int try_faults(const std::filesystem::path& table, unsigned every, const ProveOptions& options);

}  // namespace canproof::host::prove
