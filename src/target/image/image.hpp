// What src/devices/NAME/target/device.cpp and interrupts.cpp know of each other.
#pragma once

#include "target/stm32f405/image_check.hpp"

/// The interrupt of received frames: the device's file drains its controller.
extern "C" void can_received();

namespace canproof::target {

/// Whether flash holds what seal has sealed.
bool is_sound();

}  // namespace canproof::target
