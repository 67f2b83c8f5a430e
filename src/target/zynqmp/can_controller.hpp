// SPDX-License-Identifier: Apache-2.0
// A CAN controller of the Zynq UltraScale+ on and off the bus: configuration mode, bit rate, acceptance filters, error
// states (UG1085 chapter 20, UG1087). It never waits: advance() takes the next step when the hardware is ready for it.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/node.hpp"
#include "target/zynqmp/bit_timing.hpp"
#include "target/zynqmp/can_registers.hpp"

namespace canproof::zynqmp {

class CanController {
  public:
    /// Longest time to wait for a step of the hardware. It is longer than any frame takes at 10 kbit/s.
    static constexpr Duration most_wait = milliseconds(1000U);
    /// Time off the bus after a new bit rate in bus-off. A reset clears the error counters, so the controller cannot
    /// count 128 times 11 recessive bits, which take at least 140.8 ms at 10 kbit/s.
    static constexpr Duration bus_off_rest = milliseconds(250U);

    /// `clock_hz`: CAN_REF_CLK.
    CanController(CanRegisters& registers, const std::uint32_t clock_hz) noexcept
        : registers_{registers}, clock_hz_{clock_hz} {}

    /// Resets the controller and joins the bus at `bit_rate` bit/s; in bus-off, it joins after `bus_off_rest`. With a
    /// rate that the clock cannot generate it stays off the bus.
    void set_bit_rate(std::uint32_t bit_rate, Instant now) noexcept;
    /// Returns the last requested bit rate; 0 before the first.
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }

    void advance(Instant now) noexcept;
    bool is_on_bus() const noexcept { return phase_ == Phase::on_bus; }
    /// Returns the state; bus-off also while the controller cannot join the bus.
    CanState state() const noexcept { return state_; }

  private:
    enum class Phase : std::uint8_t { off, resetting, filtering, joining, on_bus };

    void reset(Instant now) noexcept;
    void begin(Phase phase, Instant now) noexcept;
    void configure() noexcept;
    void give_up_waiting(Instant now) noexcept;
    static CanState state_of(std::uint32_t status) noexcept;

    CanRegisters& registers_;
    std::uint32_t clock_hz_;
    std::uint32_t bit_rate_{0U};
    BitTiming timing_{};
    Phase phase_{Phase::off};
    CanState state_{CanState::error_active};
    Instant since_{};        ///< start of the present phase
    Instant rests_until_{};  ///< the controller does not join the bus before
};

}  // namespace canproof::zynqmp
