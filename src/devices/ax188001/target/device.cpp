// SPDX-License-Identifier: Apache-2.0
// The AX188001 as an image that is flashed onto an STM32F405.
#include "devices/ax188001/target/wiring.hpp"
#include "target/image/image.hpp"

namespace {

using namespace canproof;

// The table of bit rates of this device contains 800 kbit/s, which needs a core clock of 160 MHz (clock.hpp).
target::DeviceImage<ax188001::Device, ax188001::Wiring, ax188001::FactoryData, 1024> image{stm32f405::core_160_mhz};

}  // namespace

extern "C" void can_received() {
    image.drain();
}

extern "C" void device_failed() {
    image.stop();
}

extern "C" void image_main() {
    image.run();
}
