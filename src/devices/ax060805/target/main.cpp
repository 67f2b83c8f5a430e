// SPDX-License-Identifier: Apache-2.0
// The AX060805 as an image for measurements: how much flash, RAM and stack of the STM32F405 it needs
// (src/target/board.hpp).
#include "devices/ax060805/firmware/ax060805.hpp"
#include "target/board.hpp"

namespace {

using namespace canproof;

target::MappedMemory<4096> memory;
TransmitQueue queue;
ax060805::Device device{memory, queue, ax060805::FactoryData{}};

[[gnu::used, gnu::section(".footprint")]] const target::Footprint footprint =
    target::footprint<generated::ax060805::tables>;

}  // namespace

extern "C" void image_main() {
    target::run<ax060805::Device, ax060805::Inputs, ax060805::Outputs>(device, queue);
}
