// SPDX-License-Identifier: Apache-2.0
// The base class of all test fixtures with a device (benches). A bench has a device, frames as in a candump log, a fake
// clock, and a memory that outlives the device.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/memory.hpp"
#include "tests/support/bench_watch.hpp"
#include "tests/support/bus_time.hpp"
#include "tests/support/settings_watch.hpp"

namespace canproof::test {

using Frames = std::vector<std::string>;

/// Handles the frames and the time of a device. A derived bench creates the device and powers it on.
template <typename Device>
class FrameBench {
  public:
    explicit FrameBench(std::size_t memory_size) : memory{memory_size} {}

    Frames send(const std::string& text) { return deliver(text, Work::frame); }
    /// Sends a frame whose work needs frames that came before, so that a bus cannot be full of such frames.
    Frames send_alone(const std::string& text) { return deliver(text, Work::lone_frame); }
    /// Lets `ms` milliseconds pass and advances the device at each of its deadlines. Returns the sent frames as
    /// `milliseconds:frame`; the milliseconds count from this call.
    Frames pass(std::uint64_t ms) {
        const Instant start = now;
        const Instant end = now + milliseconds(ms);
        Frames all;
        while (device->next_deadline() <= end) {
            now = device->next_deadline() < now ? now : device->next_deadline();
            const Work work = tick_work();
            bench_watch.begins(work);
            device->advance(now);
            bench_watch.ends(work, "");
            bus_time_.begin(now);
            watch_settings();
            watch_invariants();
            if (device->next_deadline() <= now) {
                ADD_FAILURE() << "what is due at " << now.us << " us is not done: the device would be asked for ever";
                return all;
            }
            for (const auto& frame : sent()) {
                all.push_back(std::to_string(elapsed(start, now).us / 1000) + ":" + frame);
            }
        }
        now = end;
        return all;
    }
    Frames sent() {
        Frames all;
        while (!is_blocked && !queue.empty()) {
            const Frame frame = queue.pop();
            bench_watch.said(now, frame);
            all.push_back(host::format_frame(frame));
        }
        return all;
    }
    /// Switches a device on by calling `power_on`. Returns the frames that the device sends.
    template <typename PowerOn>
    Frames switch_on(const PowerOn& power_on) {
        bench_watch.begins(Work::power_on);
        power_on();
        bench_watch.ends(Work::power_on, "");
        switched_on_ = now;
        bus_time_.begin(now);
        forget_settings();
        watch_invariants();
        return sent();
    }
    /// Makes the check of the settings begin again. A test that replaces the device without switch_on() calls it.
    void forget_settings() { settings_watch_ = SettingsWatch{}; }
    /// Checks the invariant of every service of the device. A step of the bench calls it at its end.
    void watch_invariants() const {
        const char* const service = device->node().inconsistent_service();
        if (service != nullptr) {
            ADD_FAILURE() << "the invariant of a service does not hold: " << service;
        }
    }

    host::Memory memory;
    TransmitQueue queue;
    bool is_blocked{false};  ///< nothing can be sent, for example because of disturbances: frames wait in the queue
    Instant now{};
    std::unique_ptr<Device> device;

  private:
    // The simulated slave of the conformance tests offers no settings(); `long` makes the second function the last
    // choice.
    template <typename Any>
    static auto settings_of(const Any& any, int) -> decltype(any.settings()) {
        return any.settings();
    }
    template <typename Any>
    static NodeSettings settings_of(const Any&, long) {
        return {};
    }
    Work tick_work() const {
        if (!bus_time_.is_enough(now)) {
            return Work::crowded_tick;
        }
        return elapsed(switched_on_, now).us <= first_us ? Work::first_tick : Work::tick;
    }
    void watch_settings() { settings_watch_.look(settings_of(*device, 0)); }
    Frames deliver(const std::string& text, Work idle) {
        const Frame frame = host::parse_frame(text, "test");
        const Work found = frame_work(device->next_deadline(), now);
        const Work work = found == Work::frame ? idle : found;
        bus_time_.add(frame);
        bench_watch.heard(now, frame);
        bench_watch.begins(work);
        device->receive(frame, now);
        bench_watch.ends(work, text.c_str());
        watch_settings();
        watch_invariants();
        return sent();
    }

    static constexpr std::uint64_t first_us = 1000;

    SettingsWatch settings_watch_;
    Instant switched_on_{};
    BusTime bus_time_;
};

/// A device of the catalogue with its physical inputs and the factory data (such as calibration) of one device.
template <typename Device, typename Inputs, typename FactoryData>
class UnitBench : public FrameBench<Device> {
  public:
    using FrameBench<Device>::FrameBench;

    /// Creates a new device on the memory of the previous one and powers it on, as in a power cycle. Returns the frames
    /// that it sends.
    Frames power_on() {
        this->queue = TransmitQueue{};
        this->device = std::make_unique<Device>(this->memory, this->queue, factory);
        return this->switch_on([this] { this->device->power_on(inputs, this->now); });
    }
    Frames set_inputs() {
        this->device->set_inputs(inputs, this->now);
        this->watch_invariants();
        return this->sent();
    }

    FactoryData factory{};
    Inputs inputs{};
};

}  // namespace canproof::test
