// SPDX-License-Identifier: Apache-2.0
// Compares a normal run with a naive run. In the normal run, nodes receive only frames that their filters accept, and
// are advanced only when something is due. In the naive run every node receives every frame and is advanced at every
// step. Both must have the same frames.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/advance_device.hpp"
#include "host/sim/run/run_session.hpp"

namespace canproof::host {

namespace {

const std::vector<std::string> names{"cbx-ao412@5", "cbx-ao412@6", "ax188001@7", "ax130751@8", "ax060805@9"};

/// An event of the run: a frame that no node sends, or a stimulus for one node.
struct Event {
    std::uint64_t us{0};
    std::string frame;
    std::string signal;
    double value{0.0};
};

std::string any_request() {
    static const std::vector<std::string> requests{"000#0100",
                                                   "000#8005",
                                                   "000#8106",
                                                   "000#8200",
                                                   "000#0107",
                                                   "080#",
                                                   "080#01",
                                                   "705#R",
                                                   "706#R",
                                                   "185#R",
                                                   "187#R",
                                                   "00000185#R",
                                                   "205#FF7F0000",
                                                   "206#FF7FFF7F",
                                                   "208#0102030405",
                                                   "7E5#0401000000000000",
                                                   "7E5#0400000000000000",
                                                   "605#23001401850100C0",
                                                   "605#2300140106030080",
                                                   "605#2300140106030000",
                                                   "606#2300140106030040",
                                                   "607#231610010A000500",
                                                   "605#2B17100005000000",
                                                   "608#2B17100007000000",
                                                   "609#2B17100003000000",
                                                   "605#23001801060300C0",
                                                   "605#2300180106030000",
                                                   "607#2300180105020000",
                                                   "605#4000100000000000",
                                                   "606#4008100000000000",
                                                   "606#6000000000000000",
                                                   "608#4018100100000000",
                                                   "609#2F00180201000000"};
    return *rc::gen::elementOf(requests);
}

std::vector<Event> any_events() {
    std::vector<Event> events(*rc::gen::inRange<std::size_t>(1, 60));
    std::uint64_t us = 1000;
    for (Event& one : events) {
        us += *rc::gen::inRange<std::uint64_t>(0, 8000);
        one.us = us;
        if (*rc::gen::inRange(0, 8) == 0) {
            one.signal = "can_state";
            one.value = *rc::gen::element(0.0, 1.0, 2.0);
        } else {
            one.frame = any_request();
        }
    }
    return events;
}

BusFaultRates any_faults() {
    BusFaultRates faults;
    if (*rc::gen::arbitrary<bool>()) {
        faults.corrupted = *rc::gen::element(0.0, 0.05, 0.5);
        faults.lost = *rc::gen::element(0.0, 0.05);
        faults.bus_off = *rc::gen::element(0.0, 0.01);
        faults.seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
    }
    return faults;
}

/// A node of the naive run: it accepts every frame, and does not tell the bus when its next frame changes. So the bus
/// must inspect the node at every step.
class OpenNode final : public BusNode {
  public:
    explicit OpenNode(const std::string& name) : name_{name}, device_{choose_device(name).device} {}

    SimulatedDevice& device() { return *device_; }

    const std::string& name() const override { return name_; }
    const Frame* next_frame() const override { return device_->queue().front(); }
    void take_frame() override { device_->queue().pop(); }
    void receive(const Frame& frame, Instant now) override { device_->receive(frame, now); }
    void set_can_state(CanState state, Instant now) override {
        device_->set_input("can_state", static_cast<double>(state), now);
    }
    void set_overrun(bool lost, Instant now) override { device_->set_input("can_overrun", lost ? 1.0 : 0.0, now); }
    const std::vector<AcceptanceFilter>& filters() const override { return accept_everything(); }
    std::uint32_t bit_rate() const override { return device_->bit_rate(); }

  private:
    std::string name_;
    std::unique_ptr<SimulatedDevice> device_;
};

class NaiveRun {
  public:
    explicit NaiveRun(const BusFaultRates& faults) : bus_{"inproc", 125000, faults} {
        bus_.listen([this](const BusFrame& frame) {
            log_ +=
                format_candump_line({frame.time, "inproc", frame.frame}) + (frame.sender != nullptr ? " T\n" : " R\n");
        });
        for (const std::string& name : names) {
            nodes_.push_back(std::make_unique<OpenNode>(name));
            nodes_.back()->device().power_on(Instant{});
            bus_.attach(*nodes_.back());
        }
        bus_.advance(Instant{});
    }

    void advance_to(Instant now) {
        for (Instant due = next(); due <= now; due = next()) {
            step(due < now_ ? now_ : due);
        }
        now_ = now;
    }
    void play(const Event& event) {
        if (event.signal.empty()) {
            static_cast<void>(bus_.put(parse_frame(event.frame, "law"), now_));
            step(now_);
            return;
        }
        for (auto& node : nodes_) {
            node->device().set_input(event.signal, event.value, now_);
        }
        bus_.advance(now_);
    }
    const std::string& log() const { return log_; }

  private:
    Instant next() const {
        Instant due = bus_.next_deadline();
        for (const auto& node : nodes_) {
            due = earliest(due, node->device().next_deadline());
        }
        return due;
    }
    void step(Instant at) {
        now_ = at;
        for (auto& node : nodes_) {
            advance_device(node->device(), node->name(), at);
        }
        bus_.advance(at);
    }

    std::vector<std::unique_ptr<OpenNode>> nodes_;
    ArbitratedBus bus_;
    Instant now_{};
    std::string log_;
};

}  // namespace

RC_GTEST_PROP(DeliveryLaw, RunWithFiltersHasTheSameFramesAsARunWithoutFilters, ()) {
    const std::vector<Event> events = any_events();
    const BusFaultRates faults = any_faults();
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    for (const std::string& name : names) {
        nodes.push_back(std::make_unique<DeviceNode>(name, choose_device(name).device));
    }
    std::ostringstream log;
    SessionOutputs outputs;
    outputs.log = &log;
    outputs.log_format = LogFormat::marked;
    RunSession session{std::make_unique<ArbitratedBus>("inproc", 125000, faults), std::move(nodes), {}, outputs};
    session.power_on();
    NaiveRun naive{faults};
    for (const Event& event : events) {
        session.advance_to(Instant{event.us});
        naive.advance_to(Instant{event.us});
        if (event.signal.empty()) {
            static_cast<void>(session.put(parse_frame(event.frame, "law")));
        } else {
            session.schedule({"law", Instant{event.us}, event.signal, event.value});
            session.advance_to(Instant{event.us});
        }
        naive.play(event);
    }
    session.advance_to(Instant{events.back().us + 100000});
    naive.advance_to(Instant{events.back().us + 100000});
    RC_ASSERT(log.str() == naive.log());
}

}  // namespace canproof::host
