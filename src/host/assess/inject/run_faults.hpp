// SPDX-License-Identifier: Apache-2.0
// Runs a device with one injected fault at a time, each in a process of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "host/assess/inject/fault_effect.hpp"
#include "host/assess/inject/fault_plan.hpp"
#include "host/base/shard.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/replay/replay.hpp"

namespace canproof::host {

struct InjectedRun {
    InjectedFault fault;
    FaultEffect effect{FaultEffect::masked};
};

struct InjectionCampaign {
    std::vector<RegionSize> regions;
    std::size_t calls{0};  ///< number of calls of the device in the run without a fault
    std::vector<InjectedRun> runs;
};

struct InjectionOptions {
    std::uint64_t seed{1};
    std::size_t faults{1000};
    unsigned jobs{1};          ///< number of processes at the same time
    double most_seconds{1.0};  ///< processor time in seconds after which a run counts as stopped by the watchdog
    Shard shard{};             ///< runs only this part of the faults
    std::string sources{};     ///< source_hash() of the source tree; `--merge` compares it between the shards
};

/// A function that makes a device in the state before power-on. Each call returns an equal device.
using MakeDevice = std::function<std::unique_ptr<SimulatedDevice>()>;

/// Plays `input` (its `frames`, not its `source`) twice without a fault. During the second run, before the call of each
/// fault, a copy of the process inverts the bit and continues to the end. `progress` receives the number of completed
/// runs with a fault. Throws InputError for a device without a description of its memory, and when a process cannot be
/// started or its effect cannot be judged.
InjectionCampaign run_faults(const MakeDevice& make, const ReplayInput& input, const InjectionOptions& options,
                             const std::function<void(std::size_t)>& progress);

}  // namespace canproof::host
