// SPDX-License-Identifier: Apache-2.0
// The AX188001 as an image for measurements: how much flash, RAM and stack of the STM32F405 it needs
// (src/target/board.hpp).
#include "devices/ax188001/firmware/ax188001.hpp"
#include "target/board.hpp"

namespace {

using namespace canproof;

target::MappedMemory<1024> memory;
TransmitQueue queue;
ax188001::Device device{memory, queue, ax188001::FactoryData{}};

[[gnu::used, gnu::section(".footprint")]] const target::Footprint footprint =
    target::footprint<generated::ax188001::tables>;

}  // namespace

extern "C" void image_main() {
    target::run<ax188001::Device, ax188001::Inputs, ax188001::Outputs>(device, queue);
}
