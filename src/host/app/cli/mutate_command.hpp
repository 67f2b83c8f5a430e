// `canproof mutate`: are broken requirements noticed?
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace canproof::host {

struct MutateOptions {
    std::string root{"."};
    std::string programs;  ///< folder; empty: build/mutation below the root
    std::string subject;   ///< device, id or nothing; of code: part of a file's path
    bool code{false};      ///< mutants of the firmware's code instead of generated cells
    bool kills{false};     ///< writes reports/kills.csv: which tests notice a mutant of what they claim
    std::size_t sample{0};
    std::uint64_t seed{1};
    unsigned jobs{2};
};

/// 1 when an alteration survives without a reason. Returns the exit status.
int mutate(const MutateOptions& options);

}  // namespace canproof::host
