// SPDX-License-Identifier: Apache-2.0
// A device that records each call with its time, so that a test sees which calls a replay makes.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/base/time_text.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host::test {

/// Has inputs `one` and `two`, which are also its outputs. Work is due every `period` and sends the frame `beat`.
class RecordingDevice final : public SimulatedDevice {
  public:
    explicit RecordingDevice(Duration period = {}, std::string beat = "")
        : SimulatedDevice{16}, period_{period}, beat_{std::move(beat)} {}

    void set_node_id(NodeId) override {}
    void power_on(Instant now) override {
        say(now, "on");
        due_ = period_.us == 0 ? never : now + period_;
    }
    void receive(const Frame& frame, Instant now) override {
        say(now, format_frame(frame));
        if (frame.id == echoed) {
            Frame answer = frame;
            answer.id = echoed + 1U;
            queue_.push(answer);
        }
    }
    void advance(Instant now) override {
        while (due_ <= now) {
            say(due_, "due");
            due_ = due_ + period_;
            if (!beat_.empty()) {
                queue_.push(parse_frame(beat_, "test"));
            }
        }
    }
    Instant next_deadline() const override { return due_; }
    bool set_input(const std::string& name, double value, Instant now) override {
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (names_[i] == name) {
                values_[i] = value;
                say(now, fmt::format("{}={}", name, value));
                return true;
            }
        }
        return false;
    }
    std::vector<double> inputs() const override { return values_; }
    const std::vector<std::string>& input_names() const override { return names_; }
    std::vector<double> outputs() const override { return values_; }
    const std::vector<std::string>& output_names() const override { return names_; }
    std::uint8_t node_id() const override { return 5; }
    NmtState state() const override { return NmtState::operational; }
    std::uint32_t bit_rate() const override { return 0; }

    /// The recorded calls as `seconds what`, in the time of the device.
    std::vector<std::string> told;

    /// The device answers a frame with this identifier at once with the next identifier.
    static constexpr std::uint32_t echoed = 0x300;

  private:
    void say(Instant now, const std::string& what) { told.push_back(format_seconds(now) + " " + what); }

    Duration period_;
    std::string beat_;
    Instant due_{never};
    std::vector<std::string> names_{"one", "two"};
    std::vector<double> values_{0.0, 0.0};
};

}  // namespace canproof::host::test
