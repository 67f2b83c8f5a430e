// SPDX-License-Identifier: Apache-2.0
// Makes the system calls for raw CAN sockets of Linux.
#pragma once

#include "host/sim/bus/can_system.hpp"

namespace canproof::host {

/// Returns the program's only object that makes these system calls.
CanSystem& linux_can_system();

}  // namespace canproof::host
