// SPDX-License-Identifier: Apache-2.0
// The AX130751 as an image that is flashed onto an STM32F405.
#include "devices/ax130751/target/wiring.hpp"
#include "target/image/image.hpp"

namespace {

using namespace canproof;

// The bit rates of this device include 666.667 kbit/s, which needs a core clock of 168 MHz (clock.hpp). They do not
// include 800 kbit/s, which needs 160 MHz.
target::DeviceImage<ax130751::Device, ax130751::Wiring, ax130751::FactoryData, 8192> image{stm32f405::core_168_mhz};

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
