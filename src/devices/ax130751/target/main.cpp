// SPDX-License-Identifier: Apache-2.0
// The AX130751 as an image for measurements: how much flash, RAM and stack of the STM32F405 it needs
// (src/target/board.hpp).
#include "devices/ax130751/firmware/ax130751.hpp"
#include "target/board.hpp"

namespace {

using namespace canproof;

target::MappedMemory<8192> memory;
TransmitQueue queue;
ax130751::Device device{memory, queue, ax130751::FactoryData{}};

[[gnu::used, gnu::section(".footprint")]] const target::Footprint footprint =
    target::footprint<generated::ax130751::tables>;

}  // namespace

extern "C" void image_main() {
    target::run<ax130751::Device, ax130751::Inputs, ax130751::Outputs>(device, queue);
}
