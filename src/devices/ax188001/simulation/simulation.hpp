// SPDX-License-Identifier: Apache-2.0
// The simulated AX188001.
#pragma once

#include <memory>

#include "host/sim/devices/simulated_device.hpp"

namespace canproof::ax188001 {

/// Makes a unit with these factory values. Throws InputError for a value that its type cannot hold.
std::unique_ptr<host::SimulatedDevice> make_simulation(const host::FactoryValues& factory = {});

}  // namespace canproof::ax188001
