// Bit timing of bxCAN: how many time quanta a bit has, and where in it the bus is sampled (RM0090 32.7.7).
#pragma once

#include <cstdint>

#include "firmware/base/result.hpp"

namespace canproof::stm32f405 {

/// A bit is one quantum of synchronisation, `before_sample` quanta, the sample point, and `after_sample` quanta.
struct BitTiming {
    std::uint32_t prescaler{1U};      ///< 1…1024 clocks of APB1 a quantum
    std::uint32_t before_sample{1U};  ///< 1…16
    std::uint32_t after_sample{1U};   ///< 1…8
    std::uint32_t jump{1U};           ///< 1…4 quanta by which a bit is lengthened or shortened at most

    constexpr std::uint32_t quanta() const noexcept { return 1U + before_sample + after_sample; }
    /// Clocks of APB1 that a bit takes.
    constexpr std::uint32_t clocks() const noexcept { return prescaler * quanta(); }
};

enum class BitTimingError : std::uint8_t {
    none,
    no_such_rate  ///< no divider of the clock comes within `most_error_ppm` of it
};

/// The most that a bit rate may be off what was asked for. CAN itself allows some 0.5 % between the clocks of two nodes
/// with the jump widths used here.
constexpr std::uint32_t most_error_ppm = 4100U;

/// The timing with the least error for `bit_rate` (bit/s) at a clock of APB1 of `clock_hz` (at most 45 MHz); of several
/// that with the sample point nearest to 87.5 % of the bit (CiA 301, 5.2), then with the most quanta.
Result<BitTiming, BitTimingError> bit_timing(std::uint32_t clock_hz, std::uint32_t bit_rate) noexcept;

/// CAN_BTR (RM0090 32.9.2) of a timing.
constexpr std::uint32_t bit_timing_register(const BitTiming& timing) noexcept {
    return ((timing.jump - 1U) << 24U) | ((timing.after_sample - 1U) << 20U) | ((timing.before_sample - 1U) << 16U) |
           (timing.prescaler - 1U);
}

}  // namespace canproof::stm32f405
