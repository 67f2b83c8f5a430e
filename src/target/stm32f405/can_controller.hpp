// SPDX-License-Identifier: Apache-2.0
// bxCAN on and off the bus: initialisation, bit rate, acceptance filters, error states, recovery from bus-off (RM0090
// 32.4, 32.7.4, 32.7.6, 32.9.2). It never waits: advance() takes the next step when the hardware has acknowledged the
// last one.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/node.hpp"
#include "target/stm32f405/bit_timing.hpp"
#include "target/stm32f405/bxcan_registers.hpp"

namespace canproof::stm32f405 {

class CanController {
  public:
    /// Time-out for the hardware's acknowledgement of a step: longer than any frame takes at 10 kbit/s.
    static constexpr Duration most_wait = milliseconds(1000U);
    /// Time from bus-off to the start of the recovery.
    static constexpr Duration bus_off_rest = milliseconds(100U);

    /// `clock_hz`: the clock of APB1, which drives the controller.
    CanController(BxcanRegisters& registers, const std::uint32_t clock_hz) noexcept
        : registers_{registers}, clock_hz_{clock_hz} {}

    /// Leaves the bus and joins it again at `bit_rate` bit/s; after bus-off, it joins not before the pause is over.
    /// With a rate that the clock cannot generate it stays off the bus.
    void set_bit_rate(std::uint32_t bit_rate, Instant now) noexcept;
    /// Returns the last requested bit rate; 0 before the first request.
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }

    void advance(Instant now) noexcept;
    /// Returns whether the controller has left initialisation mode. This can also be true in bus-off: see state().
    bool is_on_bus() const noexcept { return phase_ == Phase::on_bus; }
    /// Returns the state of the controller; it is also bus-off while the controller cannot join the bus.
    CanState state() const noexcept { return state_; }

  private:
    enum class Phase : std::uint8_t { off, entering, leaving, on_bus };
    enum class Recovery : std::uint8_t {
        none,
        resting,  ///< the pause after bus-off
        counting  ///< the hardware counts recessive bits, or does so after the present initialisation
    };

    void enter(Instant now) noexcept;
    void leave(Instant now) noexcept;
    void configure() noexcept;
    void set_filters() noexcept;
    void watch_bus(Instant now) noexcept;
    bool may_recover(Instant now) noexcept;
    void give_up_waiting(Instant now) noexcept;
    CanState read_state() const noexcept;

    BxcanRegisters& registers_;
    std::uint32_t clock_hz_;
    std::uint32_t bit_rate_{0U};
    BitTiming timing_{};
    Phase phase_{Phase::off};
    CanState state_{CanState::error_active};
    Instant since_{};      ///< start of the present phase
    Instant off_since_{};  ///< start of the bus-off state; valid in Recovery::resting
    Recovery recovery_{Recovery::none};
};

}  // namespace canproof::stm32f405
