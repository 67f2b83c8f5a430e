// SPDX-License-Identifier: Apache-2.0
// Addresses of the peripherals of a Zynq UltraScale+ (UG1085 chapter 10, "I/O Peripherals Registers"; UG1087). Only
// images use this file; tests pass models to the drivers.
#pragma once

#include "target/zynqmp/can_registers.hpp"

namespace canproof::zynqmp {

constexpr std::uintptr_t can0_address = 0xFF060000U;
constexpr std::uintptr_t can1_address = 0xFF070000U;
constexpr std::uintptr_t gic_distributor_address = 0xF9010000U;
constexpr std::uintptr_t gic_interface_address = 0xF9020000U;

/// CAN_REF_CLK of both controllers. QEMU's machine has 24 MHz; on a board CRL_APB.CAN0_REF_CTRL and CAN1_REF_CTRL
/// divide a PLL.
constexpr std::uint32_t can_clock_hz = 24000000U;

/// Returns the registers at an address.
template <typename Registers>
inline Registers& registers_at(const std::uintptr_t address) noexcept {
    return *reinterpret_cast<Registers*>(address);
}

}  // namespace canproof::zynqmp
