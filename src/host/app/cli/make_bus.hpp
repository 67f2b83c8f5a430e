// SPDX-License-Identifier: Apache-2.0
// Makes the bus that `--bus` names.
#pragma once

#include <memory>

#include "host/app/cli/run_command.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host {

/// Returns the bus; `bit_rate` is the bit rate of the devices in bit/s. Throws InputError when `options` names no bus,
/// or names faults for a bus without simulated faults.
std::unique_ptr<Bus> make_bus(const RunOptions& options, std::uint32_t bit_rate);
/// Returns whether the bus belongs to a server that this program has not joined (yet). The run has then not started.
bool is_joining(const Bus& bus);

}  // namespace canproof::host
