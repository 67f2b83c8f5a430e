// SPDX-License-Identifier: Apache-2.0
// Bit timing of bxCAN: the number of time quanta of a bit, and the position of the sample point (RM0090 32.7.7).
#pragma once

#include <cstdint>

#include "firmware/base/result.hpp"

namespace canproof::stm32f405 {

/// The parts of a bit: one synchronisation quantum, `before_sample` quanta, the sample point, `after_sample` quanta.
struct BitTiming {
    std::uint32_t prescaler{1U};      ///< 1…1024 clocks of APB1 per quantum
    std::uint32_t before_sample{1U};  ///< 1…16 quanta
    std::uint32_t after_sample{1U};   ///< 1…8 quanta
    std::uint32_t jump{1U};           ///< 1…4 quanta: the most by which a bit is lengthened or shortened

    constexpr std::uint32_t quanta() const noexcept { return 1U + before_sample + after_sample; }
    /// Returns the clocks of APB1 per bit.
    constexpr std::uint32_t clocks() const noexcept { return prescaler * quanta(); }
};

enum class BitTimingError : std::uint8_t {
    none,
    no_such_rate  ///< no divider of the clock gives the rate within `most_error_ppm`
};

/// The greatest deviation of a bit rate from the wanted one. CAN itself allows about 0.5 % between the clocks of two
/// nodes with the jump widths used here.
constexpr std::uint32_t most_error_ppm = 4100U;

/// Returns the timing with the least error for `bit_rate` (bit/s) at an APB1 clock of `clock_hz` (at most 45 MHz). Of
/// several such timings it returns the one with the sample point nearest to 87.5 % of the bit (CiA 301, 5.2), then with
/// the most quanta.
Result<BitTiming, BitTimingError> bit_timing(std::uint32_t clock_hz, std::uint32_t bit_rate) noexcept;

/// Returns the value of CAN_BTR (RM0090 32.9.2) for a timing.
constexpr std::uint32_t bit_timing_register(const BitTiming& timing) noexcept {
    return ((timing.jump - 1U) << 24U) | ((timing.after_sample - 1U) << 20U) | ((timing.before_sample - 1U) << 16U) |
           (timing.prescaler - 1U);
}

}  // namespace canproof::stm32f405
