// SPDX-License-Identifier: Apache-2.0
// `canproof mutate`: whether a test notices each broken requirement.
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
    std::string subject;   ///< device, id or empty; for mutants of code: part of a file's path
    bool code{false};      ///< alters the code of the firmware instead of generated cells
    bool kills{false};     ///< writes reports/kills.csv: the mutants that each test notices of the items it verifies
    std::size_t sample{0};
    std::uint64_t seed{1};
    unsigned jobs{2};
    std::optional<Shard> shard{};  ///< judges only this part of a run and writes its outcomes below `programs`
    std::string merge;  ///< folder of the shards of a run, which are merged instead of a new run; empty: judge
    bool json{false};   ///< the outcomes as JSON instead of lines
};

/// Returns the exit status: 1 when an alteration survives without a reason. A shard reports no survivors.
int mutate(const MutateOptions& options);

}  // namespace canproof::host
