// SPDX-License-Identifier: Apache-2.0
// Devices for tests of the main loop that do not need a real device.
#pragma once

#include <string>

#include "tests/support/stm32f405/device_on_models.hpp"

namespace canproof::test {

/// A device whose outputs change between their computation and their transfer to the board. In each pass the loop calls
/// bit_rate(), then compares the outputs with their copy, copies them after a computation, compares them again and
/// drives them.
struct ChangingDevice {
    cbx_ao412::Outputs values{};
    /// These two point to variables outside the device: the bytes of the device itself must not change between
    /// computations.
    int* looks{nullptr};
    bool* changes{nullptr};

    void power_on(const cbx_ao412::Inputs&, Instant) {}
    void set_inputs(const cbx_ao412::Inputs&, Instant) {}
    void receive(const Frame&, Instant) {}
    void advance(Instant) {}
    Instant next_deadline() const { return Instant{}; }  // always due: the device computes in each pass
    std::uint32_t bit_rate() const {
        *looks = 0;
        return 1000000;
    }
    NodeSettings settings() const { return {}; }
    const cbx_ao412::Outputs& outputs() const {
        static const cbx_ao412::Outputs changed{{0.0F, 8.0F, 0.0F, 0.0F}, false, false, false, false};
        ++*looks;
        return *changes && *looks > 2 ? changed : values;
    }
};

/// A device that records the order in which the loop calls it, and the identifiers of its frames. The record and the
/// deadline are outside of the device, whose bytes must not change between computations.
struct RecordingDevice {
    cbx_ao412::Outputs values{};
    std::string* calls{nullptr};
    const Instant* deadline{nullptr};  ///< without one, no deadline is ever due
    CanState* can_state{nullptr};      ///< the state in the last inputs
    int state{0};                      ///< a part of the state that is neither a setting nor an output

    void power_on(const cbx_ao412::Inputs& inputs, Instant) { note("power_on ", inputs); }
    void set_inputs(const cbx_ao412::Inputs& inputs, Instant) { note("inputs ", inputs); }
    void receive(const Frame& frame, Instant) { *calls += std::to_string(frame.id) + " "; }
    void advance(Instant) { *calls += "advance "; }
    Instant next_deadline() const { return deadline == nullptr ? never : *deadline; }
    std::uint32_t bit_rate() const { return 1000000; }
    NodeSettings settings() const { return {}; }
    const cbx_ao412::Outputs& outputs() const { return values; }
    void note(const char* call, const cbx_ao412::Inputs& inputs) {
        *calls += call;
        if (can_state != nullptr) {
            *can_state = static_cast<CanState>(inputs.can_state);
        }
    }
};

/// A main loop of a small device on the drivers and models of a Unit. A pass takes 100 us.
template <typename Device>
struct SmallLoop {
    Unit& unit;
    Device& device;
    stm32f405::DeviceLoop<Device, TestBoard> loop{device,    unit.queue,    unit.board, unit.can,
                                                  unit.time, unit.watchdog, unit.tests};

    SmallLoop(Unit& around, Device& device_of_loop, bool may_join = true) : unit{around}, device{device_of_loop} {
        loop.power_on(may_join);
    }
    void run(int passes) {
        for (int i = 0; i < passes; ++i) {
            unit.chips.timer.at(0x24) += 100;
            unit.chips.capture.pass(100);
            unit.can.drain();
            loop.pass();
        }
    }
};

}  // namespace canproof::test
