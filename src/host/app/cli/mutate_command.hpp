// SPDX-License-Identifier: Apache-2.0
// `canproof mutate`: checks whether a test notices each alteration of a requirement's data or of the code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "host/base/shard.hpp"

namespace canproof::host {

struct MutateOptions {
    std::string root{"."};
    std::string programs;  ///< folder; empty: build/mutation below `root`
    std::string subject;   ///< device or id; for mutants of code a part of a file's path; empty: everything
    bool code{false};      ///< alters the code of the firmware and of the host's buses and replay, not generated cells
    /// writes reports/kills.csv: for each test, the items that it verifies and whose mutants it notices
    bool kills{false};
    /// prints the recorded figures of code by layer instead of a run
    bool table{false};
    std::size_t sample{0};
    std::uint64_t seed{1};
    unsigned jobs{2};
    std::optional<Shard> shard{};  ///< judges only this part of a run and writes its outcomes below `programs`
    /// folder with the outcomes of all shards, which are merged instead of a new run; empty: runs the judgement
    std::string merge;
    bool json{false};  ///< the outcomes as JSON instead of lines
};

/// Runs the command that the options select. Returns the exit status: 1 when an alteration survives without a reason,
/// when a record matches no alteration, or when a record matches no survivor. A run with a subject or a sample does not
/// check the last point. Returns 0 for a shard and for `kills`. For `table`, returns 1 when a file
/// has an open survivor or was not judged in its present form.
int mutate(const MutateOptions& options);

}  // namespace canproof::host
