// SPDX-License-Identifier: Apache-2.0
// `canproof inject`: turns single bits of a running device's memory and reports what follows.
#pragma once

#include <optional>
#include <string>

#include "host/assess/inject/run_faults.hpp"

namespace canproof::host {

struct InjectOptions {
    std::string root{"."};
    std::string device;
    std::string log;       ///< frames to the device; empty: the device's workload below `root`
    std::string stimulus;  ///< changes of its inputs; empty, and no `log`: the device's workload below `root`
    std::optional<std::string> node;
    InjectionOptions campaign;
    bool json{false};
    bool is_shard{false};
    std::string out{"build/inject"};  ///< folder of the files of shards
    std::string merge;                ///< folder of all shards of a campaign, in place of running it; empty: run
};

/// Prints the table, or JSON. Returns the exit status.
int inject(const InjectOptions& options);

}  // namespace canproof::host
