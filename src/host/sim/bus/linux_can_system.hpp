// The kernel's raw CAN sockets.
#pragma once

#include "host/sim/bus/can_system.hpp"

namespace canproof::host {

/// One for the whole program.
CanSystem& linux_can_system();

}  // namespace canproof::host
