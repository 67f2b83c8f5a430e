// SPDX-License-Identifier: Apache-2.0
// Bit timing of the CAN controller (UG1087, BRPR and BTR). Its segments have the same bounds as those of bxCAN, so this
// driver uses the search of the STM32F405's driver. Only the prescaler has fewer bits, but at 24 MHz it still allows
// every bit rate of LSS.
#pragma once

#include "target/stm32f405/bit_timing.hpp"

namespace canproof::zynqmp {

using stm32f405::BitTiming;
using stm32f405::BitTimingError;

/// Greatest divider that the 8 bits of BRPR can hold.
constexpr std::uint32_t most_prescaler = 256U;

/// Returns the timing for `bit_rate` (bit/s) at a CAN reference clock of `clock_hz`.
Result<BitTiming, BitTimingError> bit_timing(std::uint32_t clock_hz, std::uint32_t bit_rate) noexcept;

/// Returns the value of BRPR for a timing.
constexpr std::uint32_t prescaler_register(const BitTiming& timing) noexcept {
    return timing.prescaler - 1U;
}

/// Returns the value of BTR for a timing: SJW from bit 7, TS2 from bit 4, TS1 from bit 0.
constexpr std::uint32_t segments_register(const BitTiming& timing) noexcept {
    return ((timing.jump - 1U) << 7U) | ((timing.after_sample - 1U) << 4U) | (timing.before_sample - 1U);
}

/// Returns the number of clocks of a bit, from the values of BRPR and BTR.
constexpr std::uint32_t clocks_of_bit(const std::uint32_t prescaler, const std::uint32_t timing) noexcept {
    const std::uint32_t before_sample = (timing & 0xFU) + 1U;
    const std::uint32_t after_sample = ((timing >> 4U) & 0x7U) + 1U;
    return ((prescaler & 0xFFU) + 1U) * (1U + before_sample + after_sample);
}

}  // namespace canproof::zynqmp
