// SPDX-License-Identifier: Apache-2.0
// The independent watchdog: a counter with its own oscillator that resets the chip unless it is refreshed. Nothing
// stops it (RM0090 21.3, 21.4).
#pragma once

#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

struct WatchdogRegisters {
    Register key;        ///< 00h IWDG_KR (21.4.1)
    Register prescaler;  ///< 04h IWDG_PR (21.4.2)
    Register reload;     ///< 08h IWDG_RLR (21.4.3)
    Register status;     ///< 0Ch IWDG_SR (21.4.4)
};

class Watchdog {
  public:
    /// Period in ms at the nominal 32 kHz. The oscillator runs at 17 to 47 kHz (data sheet): 0.68 to 1.9 s, longer than
    /// the 0.5 s for which an erase of 16 KiB stops the processor.
    static constexpr std::uint32_t period_ms = 1000U;
    /// The limit of polls for a new value. It becomes effective within five cycles of the oscillator, at most 0.3 ms; a
    /// poll takes at least six cycles at 168 MHz, so this number of polls takes at least 35 ms.
    static constexpr std::uint32_t usual_polls = 1000000U;

    explicit Watchdog(WatchdogRegisters& registers, const std::uint32_t most_polls = usual_polls) noexcept
        : registers_{registers}, most_polls_{most_polls} {}

    /// Starts the watchdog: from now on refresh() is due within 0.68 s, the shortest period. Returns false when the
    /// hardware did not report that it accepted the period: the period is then 0.125, 0.512, 1 or 4.096 s (nominal).
    bool start() noexcept;
    void refresh() noexcept;

  private:
    bool waits_for_update() const noexcept;

    WatchdogRegisters& registers_;
    std::uint32_t most_polls_;
};

}  // namespace canproof::stm32f405
