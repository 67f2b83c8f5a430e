// SPDX-License-Identifier: Apache-2.0
// A device on the microcontroller: power-on, then one pass after the other. Its board reads physical inputs and drives
// outputs: a class with the types Inputs and Outputs and the functions
//   void start(); void read(Inputs&); void drive(const Outputs&);
#pragma once

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "target/stm32f405/time_base.hpp"
#include "target/stm32f405/watchdog.hpp"

namespace canproof::stm32f405 {

template <typename Device, typename Board>
class DeviceLoop {
  public:
    /// A pass takes at most this many waiting frames, so that outputs and watchdog are served in time.
    static constexpr std::uint32_t frames_a_pass = 8U;
    /// A lost frame is reported for this long, so that an LED shows it.
    static constexpr Duration overrun_time = milliseconds(1000U);

    DeviceLoop(Device& device, TransmitQueue& queue, Board& board, Bxcan& can, TimeBase& time,
               Watchdog& watchdog) noexcept
        : device_{device}, queue_{queue}, board_{board}, can_{can}, time_{time}, watchdog_{watchdog} {}

    /// Powers the device on. `may_join`: the clock is accurate enough for the bus.
    void power_on(const bool may_join) noexcept {
        may_join_ = may_join;
        static_assert(implements<req::CO_WATCHDOG_001>);
        static_cast<void>(watchdog_.start());  // continues even if the period was not set
        const Instant now = time_.now();
        take_inputs(now);
        device_.power_on(inputs_, now);
    }

    void pass() noexcept {
        const Instant now = time_.now();
        static_assert(implements<req::CO_CLOCK_001>);
        if (may_join_ && (can_.bit_rate() != device_.bit_rate())) {
            can_.set_bit_rate(device_.bit_rate(), now);
        }
        can_.advance(queue_, now);
        take_inputs(now);
        device_.set_inputs(inputs_, now);
        take_frames(now);
        if (device_.next_deadline() <= now) {
            device_.advance(now);
        }
        can_.advance(queue_, now);
        board_.drive(device_.outputs());
        watchdog_.refresh();
    }

  private:
    void take_inputs(const Instant now) noexcept {
        board_.read(inputs_);
        const CanState state = may_join_ ? can_.state() : CanState::bus_off;
        inputs_.can_state = static_cast<std::uint8_t>(state);
        if (can_.take_overrun()) {
            overrun_until_ = now + overrun_time;
        }
        inputs_.can_overrun = now < overrun_until_;
    }

    void take_frames(const Instant now) noexcept {
        Frame frame{};
        bool any{true};
        for (std::uint32_t count = 0U; count < frames_a_pass; ++count) {
            if (any) {
                any = can_.receive(frame);
            }
            if (any) {
                device_.receive(frame, now);
            }
        }
    }

    Device& device_;
    TransmitQueue& queue_;
    Board& board_;
    Bxcan& can_;
    TimeBase& time_;
    Watchdog& watchdog_;
    typename Board::Inputs inputs_{};
    Instant overrun_until_{};
    bool may_join_{false};
};

}  // namespace canproof::stm32f405
