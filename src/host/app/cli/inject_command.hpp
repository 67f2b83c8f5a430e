// SPDX-License-Identifier: Apache-2.0
// `canproof inject`: inverts single bits in the memory of a running device and reports the effects.
#pragma once

#include <optional>
#include <string>

#include "host/assess/inject/run_faults.hpp"

namespace canproof::host {

struct InjectOptions {
    std::string root{"."};
    std::string device;
    std::string log;  ///< candump log of the frames to the device; empty: the device's workload below `root`
    /// file with changes of the device's inputs; if `log` is empty, the device's workload replaces this file
    std::string stimulus;
    std::optional<std::string> node;
    InjectionOptions campaign;
    bool json{false};
    bool is_shard{false};
    std::string out{"build/inject"};  ///< folder for the file of a shard (the part for one of several machines)
    /// folder with the result files of all shards: merges them and injects nothing; empty: runs the campaign
    std::string merge;
};

/// Prints the result as a table or JSON. With `is_shard`, writes the result of this part to a file in `out` and prints
/// one line. Returns the exit status, which is always 0.
int inject(const InjectOptions& options);

}  // namespace canproof::host
