// SPDX-License-Identifier: Apache-2.0
// A cross-check of the core's clock: TIM5 measures the low-speed oscillator, which also drives the watchdog and depends
// on no other clock (RM0090 18.4.20, 7.2.9).
#pragma once

#include "firmware/base/time.hpp"
#include "target/stm32f405/time_base.hpp"

namespace canproof::stm32f405 {

/// The registers of TIM5, up to the one that selects the input of its channel 4.
struct CaptureRegisters {
    TimerRegisters timer;
    Reserved<3U> reserved_44{};
    Register option;  ///< 50h TIM5_OR (18.4.20)
};

static_assert(sizeof(CaptureRegisters) == 0x54U, "TIM5_OR lies at 50h");

/// The oscillator's frequency differs from chip to chip and with the temperature, from 17 to 47 kHz (data sheet). So
/// every chip notices a clock below 0.36 or above 2.77 times the planned frequency. Whether it notices a smaller error
/// depends on its oscillator.
class ClockCheck {
  public:
    static constexpr std::uint32_t periods = 8U;  ///< periods of the oscillator between two captures
    /// Limits of the time of `periods` in µs, at 47 and at 17 kHz. The lower one is rounded down, the upper one up.
    static constexpr std::uint32_t shortest_us = 170U;
    static constexpr std::uint32_t longest_us = 471U;
    /// Without a capture for this long the oscillator or the timer has stopped.
    static constexpr Duration most_wait = milliseconds(100U);

    /// `timer_mhz`: the planned frequency of the timer's clock.
    ClockCheck(CaptureRegisters& registers, const std::uint32_t timer_mhz) noexcept
        : registers_{registers}, timer_mhz_{timer_mhz} {}

    /// Starts the timer. The watchdog must have started the oscillator before.
    void start(Instant now) noexcept;
    /// Looks for a capture. Returns false when the frequency of the oscillator, measured by the clock of the core, is
    /// wrong, or when no capture came for `most_wait`. Ignores an interval during which another capture was missed.
    bool step(Instant now) noexcept;

  private:
    bool is_plausible(std::uint32_t capture) const noexcept;

    CaptureRegisters& registers_;
    std::uint32_t timer_mhz_;
    Instant seen_{};  ///< time of the last capture; before the first one, time of start()
    std::uint32_t last_{0U};
    bool has_last_{false};
};

}  // namespace canproof::stm32f405
