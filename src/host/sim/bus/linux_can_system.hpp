// SPDX-License-Identifier: Apache-2.0
// The raw CAN sockets of the kernel.
#pragma once

#include "host/sim/bus/can_system.hpp"

namespace canproof::host {

/// Returns the only object of this kind in the program.
CanSystem& linux_can_system();

}  // namespace canproof::host
