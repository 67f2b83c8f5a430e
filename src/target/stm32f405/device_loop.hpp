// SPDX-License-Identifier: Apache-2.0
// A device on the microcontroller: power-on, then one pass after the other, each with a part of the self-tests. Its
// board reads physical inputs and drives outputs: a class with the types Inputs and Outputs and the functions
//   void start(); void read(Inputs&); void drive(const Outputs&);
// Outputs{} is the safe state: what the device drives before power-on.
#pragma once

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "target/stm32f405/selftest/flow_monitor.hpp"
#include "target/stm32f405/selftest/output_copy.hpp"
#include "target/stm32f405/selftest/self_tests.hpp"
#include "target/stm32f405/selftest/settings_guard.hpp"
#include "target/stm32f405/selftest/state_guard.hpp"
#include "target/stm32f405/time_base.hpp"
#include "target/stm32f405/watchdog.hpp"

namespace canproof::stm32f405 {

/// The drivers of a device on the chip. The image for a campaign of faults has other drivers (faults/subject.hpp).
struct ChipDrivers {
    using Can = Bxcan;
    using Time = TimeBase;
    using Watchdog = stm32f405::Watchdog;
};

template <typename Device, typename Board, typename Drivers = ChipDrivers>
class DeviceLoop {
  public:
    /// Most received frames that one pass processes, so that outputs and watchdog are served in time.
    static constexpr std::uint32_t frames_a_pass = 8U;
    /// A lost frame is reported for this long, so that an LED shows it.
    static constexpr Duration overrun_time = milliseconds(1000U);
    /// Time from one sample of the physical inputs to the next. In between, the device computes only when a frame comes
    /// or a deadline is due; a checksum protects its state for the rest of the time.
    static constexpr Duration sample_time = milliseconds(1U);

    DeviceLoop(Device& device, TransmitQueue& queue, Board& board, typename Drivers::Can& can,
               typename Drivers::Time& time, typename Drivers::Watchdog& watchdog, SelfTests& tests) noexcept
        : device_{device}, queue_{queue}, board_{board}, can_{can}, time_{time}, watchdog_{watchdog}, tests_{tests} {}

    /// Starts the watchdog, tests processor and RAM, and powers the device on unless a test fails. `may_join`: the
    /// clock is accurate enough for the bus.
    void power_on(const bool may_join) noexcept {
        may_join_ = may_join;
        static_assert(implements<req::CO_WATCHDOG_001> && implements<req::CO_WATCHDOG_003>);
        static_cast<void>(watchdog_.start());  // the device also runs when the watchdog has not accepted its period
        failed_ = tests_.start(time_.now());
        if (failed_ == SelfTest::none) {
            const Instant now = time_.now();
            samples_ = true;
            take_inputs(now);
            device_.power_on(inputs_, now);
            copy_.keep(device_.outputs());
            settings_.keep(device_.settings());
            device_state_.keep();
            queue_state_.keep();
            flow_ = FlowMonitor{};
        }
    }

    /// Runs one pass of the main loop: does each step once. After a failed self-test, only drives the outputs to the
    /// safe state, until the watchdog resets the chip.
    void pass() noexcept {
        const Instant now = time_.now();
        if (failed_ == SelfTest::none) {
            serve_bus(now);
            prepare(now);
            take_inputs(now);
            run_device(now);
            transmit(now);
            drive_outputs();
            test(now);
        }
        static_assert(implements<req::CO_SELF_008> && implements<req::CO_WATCHDOG_002>);
        if (failed_ == SelfTest::none) {
            watchdog_.refresh();
        } else {
            can_.set_bit_rate(0U, now);  // leaves the bus
            board_.drive(typename Board::Outputs{});
        }
    }
    /// Returns the self-test that failed; SelfTest::none when none did.
    SelfTest failed() const noexcept { return failed_; }

  private:
    /// Compares the queue with its checksum before anything uses it, then serves the controller.
    void serve_bus(const Instant now) noexcept {
        static_assert(implements<req::CO_SELF_017>);
        if (!queue_state_.matches()) {
            fail(SelfTest::state);
        }
        if (failed_ == SelfTest::none) {
            static_assert(implements<req::CO_CLOCK_005>);
            if (may_join_ && (can_.bit_rate() != device_.bit_rate())) {
                change_bit_rate(now);
            }
            can_.advance(queue_, now);
        }
        flow_.note(Step::bus);
    }

    /// Gives the controller the bit rate of the device, unless the device's state does not match its checksum: the bit
    /// rate is part of this state.
    void change_bit_rate(const Instant now) noexcept {
        static_assert(implements<req::CO_SELF_011>);
        if (device_state_.matches()) {
            can_.set_bit_rate(device_.bit_rate(), now);
        } else {
            fail(SelfTest::state);
        }
    }

    /// Decides whether the device computes in this pass: a sample of the inputs, a frame or a deadline is due. If so,
    /// compares its state with the checksum.
    static_assert(implements<req::CO_SELF_011> && implements<req::CO_SELF_012> && implements<req::CO_SELF_018>);
    void prepare(const Instant now) noexcept {
        static_assert(implements<req::CO_SELF_020>);
        samples_ = is_due(next_sample_, sample_time, now);
        has_frame_ = can_.receive(frame_);
        computes_ = samples_ || has_frame_ || (device_.next_deadline() <= now);
        if (computes_ && (!device_state_.matches())) {
            fail(SelfTest::state);
        }
    }

    void take_inputs(const Instant now) noexcept {
        if (samples_) {
            next_sample_ = now + sample_time;
            board_.read(inputs_);
            const CanState state = may_join_ ? can_.state() : CanState::bus_off;
            inputs_.can_state = static_cast<std::uint8_t>(state);
            if (can_.take_overrun()) {
                overrun_until_ = now + overrun_time;
            }
            inputs_.can_overrun = now < overrun_until_;
        }
        flow_.note(Step::inputs);
    }

    void run_device(const Instant now) noexcept {
        compare_outputs();
        if (computes_ && (failed_ == SelfTest::none)) {
            device_.set_inputs(inputs_, now);
            take_frames(now);
            if (device_.next_deadline() <= now) {
                device_.advance(now);
            }
            copy_.keep(device_.outputs());
            static_assert(implements<req::CO_SELF_019>);
            if (!settings_.follow(device_.settings())) {
                fail(SelfTest::state);
            }
            // the state stays constant until the next computation: until then only const functions of the device are
            // called
            device_state_.keep();
        }
        flow_.note(Step::device);
    }

    void transmit(const Instant now) noexcept {
        if (failed_ == SelfTest::none) {
            can_.advance(queue_, now);
            queue_state_.keep();
        }
        flow_.note(Step::transmit);
    }

    void take_frames(const Instant now) noexcept {
        for (std::uint32_t more = frames_a_pass; more > 0U; --more) {
            if (has_frame_) {
                device_.receive(frame_, now);
                has_frame_ = (more > 1U) ? can_.receive(frame_) : false;
            }
        }
    }

    void compare_outputs() noexcept {
        if (!copy_.matches(device_.outputs())) {
            fail(SelfTest::outputs);
        }
    }

    /// Compares the outputs with those that the device computed, and drives the pins unless a self-test has failed.
    void drive_outputs() noexcept {
        compare_outputs();
        if (failed_ == SelfTest::none) {
            board_.drive(device_.outputs());
        }
        flow_.note(Step::outputs);
    }

    void test(const Instant now) noexcept {
        fail(tests_.step(now));
        flow_.note(Step::tests);
        static_assert(implements<req::CO_SELF_005>);
        if (!flow_.end()) {
            fail(SelfTest::flow);
        }
    }

    /// Records a failed self-test, unless another one has failed before.
    void fail(const SelfTest test) noexcept { failed_ = (failed_ == SelfTest::none) ? test : failed_; }

    Device& device_;
    TransmitQueue& queue_;
    Board& board_;
    typename Drivers::Can& can_;
    typename Drivers::Time& time_;
    typename Drivers::Watchdog& watchdog_;
    SelfTests& tests_;
    FlowMonitor flow_{};
    OutputCopy<typename Board::Outputs> copy_{};
    StateGuard device_state_{object_bytes(device_)};
    StateGuard queue_state_{object_bytes(queue_)};
    SettingsGuard settings_{};
    SelfTest failed_{SelfTest::none};
    typename Board::Inputs inputs_{};
    Instant overrun_until_{};
    Instant next_sample_{};
    Frame frame_{};  ///< the next received frame; valid when has_frame_
    bool has_frame_{false};
    bool samples_{false};   ///< the inputs are read in this pass
    bool computes_{false};  ///< the device runs in this pass
    bool may_join_{false};
};

}  // namespace canproof::stm32f405
