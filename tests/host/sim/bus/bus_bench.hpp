// SPDX-License-Identifier: Apache-2.0
// Nodes that send given frames and record what they receive, and a function that runs a bus from event to event.
#pragma once

#include <fmt/format.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

/// Sends the frames that a test queues and records the frames that it receives.
class PlainNode : public BusNode {
  public:
    explicit PlainNode(std::string name = "node") : name_{std::move(name)} {}

    void send(const std::string& text) { waiting.push_back(parse_frame(text, "test")); }

    const std::string& name() const override { return name_; }
    const Frame* next_frame() const override { return waiting.empty() ? nullptr : &waiting.front(); }
    void take_frame() override { waiting.pop_front(); }
    void receive(const Frame& frame, Instant now) override {
        heard.push_back(fmt::format("{} {}", now.us, format_frame(frame)));
    }
    void set_can_state(CanState state, Instant now) override {
        states.push_back(fmt::format("{} {}", now.us, static_cast<int>(state)));
        if (state == CanState::bus_off) {
            waiting.clear();
        }
    }
    void set_overrun(bool lost, Instant) override { overruns.push_back(lost); }
    const std::vector<AcceptanceFilter>& filters() const override { return accepted; }
    std::uint32_t bit_rate() const override { return rate; }

    std::deque<Frame> waiting;
    std::vector<std::string> heard;  ///< `microseconds frame`
    std::vector<std::string> states;
    std::vector<bool> overruns;
    std::vector<AcceptanceFilter> accepted{accept_everything()};
    std::uint32_t rate{0};

  private:
    std::string name_;
};

/// A node that reports its changes to the bus, as a device does.
class TellingNode final : public PlainNode {
  public:
    using PlainNode::PlainNode;

    bool tells_changes() const override { return true; }
    void send_and_tell(const std::string& text) {
        send(text);
        tell_change();
    }
    void accept(const std::vector<AcceptanceFilter>& filters) {
        accepted = filters;
        tell_change();
    }
    void use(std::uint32_t bit_rate) {
        rate = bit_rate;
        tell_change();
    }
};

/// Runs a bus until `end` and stops at each of its deadlines.
inline void run_until(Bus& bus, Instant start, Instant end) {
    bus.advance(start);
    while (bus.next_deadline() <= end) {
        bus.advance(bus.next_deadline());
    }
    bus.advance(end);
}

}  // namespace canproof::host::test
