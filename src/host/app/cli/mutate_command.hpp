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
    std::string programs;  ///< folder of the test programs; empty: build/mutation below `root`
    std::string subject;   ///< device, or id of an item; with `code` a part of a file's path; empty: everything
    bool code{false};  ///< alters the code of the firmware and the host code for buses and replay, not generated cells
    /// writes reports/kills.csv: for each test, the items that it verifies and of which it notices a mutant
    bool kills{false};
    /// prints the recorded mutation figures of the code by layer, and runs no test
    bool table{false};
    std::size_t sample{0};
    std::uint64_t seed{1};
    unsigned jobs{2};
    /// tests only this shard (the part for one of several machines) and writes its outcomes below `programs`
    std::optional<Shard> shard{};
    /// folder with the outcomes of all shards: merges them and runs no test; empty: runs the tests
    std::string merge;
    bool json{false};  ///< the outcomes as JSON instead of lines
};

/// Runs the command that the options select. Returns the exit status: 1 when an alteration survives without a reason,
/// when a record of a reason matches no alteration, or when it matches only alterations that a test notices. This last
/// check is made only in a run of all alterations. Returns 0 for a shard and for `kills`. For `table`, returns 1 when a
/// file has a surviving mutant without a reason, or has changed since its last mutation run.
int mutate(const MutateOptions& options);

}  // namespace canproof::host
