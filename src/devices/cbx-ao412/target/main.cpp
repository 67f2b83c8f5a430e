// SPDX-License-Identifier: Apache-2.0
// The CAN-CBX-AO412 as an image for measurements: how much flash, RAM and stack of the STM32F405 it needs
// (src/target/board.hpp).
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "target/board.hpp"

namespace {

using namespace canproof;

target::MappedMemory<1024> memory;
TransmitQueue queue;
cbx_ao412::Device device{memory, queue, cbx_ao412::FactoryData{}};

[[gnu::used, gnu::section(".footprint")]] const target::Footprint footprint =
    target::footprint<generated::cbx_ao412::tables>;

}  // namespace

extern "C" void image_main() {
    target::run<cbx_ao412::Device, cbx_ao412::Inputs, cbx_ao412::Outputs>(device, queue);
}
