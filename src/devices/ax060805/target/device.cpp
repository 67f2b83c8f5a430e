// SPDX-License-Identifier: Apache-2.0
// The AX060805 as an image that is flashed onto an STM32F405.
#include "devices/ax060805/target/wiring.hpp"
#include "target/image/image.hpp"

namespace {

using namespace canproof;

// The table of bit rates of this device contains 800 kbit/s, which needs a core clock of 160 MHz (clock.hpp).
target::DeviceImage<ax060805::Device, ax060805::Wiring, ax060805::FactoryData, 4096> image{stm32f405::core_160_mhz};

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
