// SPDX-License-Identifier: Apache-2.0
// The system timer of ARMv7-M (SysTick), for images that measure or limit the time of a device.
#pragma once

#include <cstdint>

namespace canproof::target {

/// Registers SYST_CSR, SYST_RVR and SYST_CVR. The timer counts down from `reload` to 0.
struct SysTick {
    volatile std::uint32_t control;
    volatile std::uint32_t reload;
    volatile std::uint32_t value;
};

constexpr std::uint32_t longest_sys_tick = 0x00FFFFFFU;  ///< the timer has 24 bits

inline SysTick& sys_tick() {
    constexpr std::uintptr_t address = 0xE000E010U;
    return *reinterpret_cast<SysTick*>(address);
}

}  // namespace canproof::target
