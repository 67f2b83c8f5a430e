// bxCAN on the bus and off it: initialisation, bit rate, acceptance filters, error states, recovery from bus-off
// (RM0090 32.4, 32.7.4, 32.7.6, 32.9.2). Never waits: advance() takes the next step when the hardware has acknowledged
// the last one.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/node.hpp"
#include "target/stm32f405/bit_timing.hpp"
#include "target/stm32f405/bxcan_registers.hpp"

namespace canproof::stm32f405 {

class CanController {
  public:
    /// Longer than any frame takes at 10 kbit/s: whoever has not acknowledged by then does not.
    static constexpr Duration most_wait = milliseconds(1000U);
    /// From bus-off to the start of the recovery.
    static constexpr Duration bus_off_rest = milliseconds(100U);

    /// `clock_hz`: that of APB1, which clocks the controller.
    CanController(BxcanRegisters& registers, const std::uint32_t clock_hz) noexcept
        : registers_{registers}, clock_hz_{clock_hz} {}

    /// Leaves the bus, and joins it again at `bit_rate` bit/s. A rate that the clock does not give keeps it off the
    /// bus.
    void set_bit_rate(std::uint32_t bit_rate, Instant now) noexcept;
    /// The rate that was asked for last; 0 before.
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }

    void advance(Instant now) noexcept;
    /// Whether frames can be sent and received.
    bool is_on_bus() const noexcept { return phase_ == Phase::on_bus; }
    /// Bus-off, too, when it cannot join the bus.
    CanState state() const noexcept { return state_; }

  private:
    enum class Phase : std::uint8_t { off, entering, leaving, on_bus };

    void enter(Instant now) noexcept;
    void configure() noexcept;
    void set_filters() noexcept;
    void watch_bus(Instant now) noexcept;
    void give_up_waiting(Instant now) noexcept;
    CanState read_state() const noexcept;

    BxcanRegisters& registers_;
    std::uint32_t clock_hz_;
    std::uint32_t bit_rate_{0U};
    BitTiming timing_{};
    Phase phase_{Phase::off};
    CanState state_{CanState::error_active};
    Instant since_{};            ///< of the phase, or of the bus-off state
    bool is_recovering_{false};  ///< the hardware counts recessive bits
};

}  // namespace canproof::stm32f405
