// SPDX-License-Identifier: Apache-2.0
// Compares the in-process bus with the naive bus of naive_bus.hpp, after each step: all frames and all states.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "properties/host/naive_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host {

namespace {

enum class Deed { send, put, send_by_door, switch_off, plug, unplug, filter, change_rate };

struct Act {
    std::uint64_t after_us{0};
    Deed deed{Deed::send};
    std::size_t which{0};
    Frame frame{};
    std::vector<NaiveBus::Filter> filters;
    std::uint64_t bit_us{0};
};

/// A node that reports its changes to the bus, as a device does.
class TellingNode final : public test::PlainNode {
  public:
    using PlainNode::PlainNode;

    bool tells_changes() const override { return true; }
    void take_frame() override {
        PlainNode::take_frame();
        tell_change();
    }
    void set_can_state(CanState state, Instant now) override {
        PlainNode::set_can_state(state, now);
        tell_change();
    }
    void tell() const { tell_change(); }
};

/// Returns random acceptance filters. A frame may be accepted by several of them, or by none.
std::vector<NaiveBus::Filter> any_filters() {
    std::vector<NaiveBus::Filter> filters(*rc::gen::inRange<std::size_t>(0, 4));
    for (NaiveBus::Filter& one : filters) {
        one.extended = *rc::gen::arbitrary<bool>();
        one.id = *rc::gen::element<std::uint32_t>(0x000, 0x001, 0x010, 0x011, 0x120, 0x7F1);
        one.mask = one.extended ? *rc::gen::element<std::uint32_t>(0x1FFFFFFF, 0x7FF, 0)
                                : *rc::gen::element<std::uint32_t>(0x7FF, 0x7F0, 0);
    }
    return filters;
}

/// Returns a frame with an identifier made of one of a few numbers: the number with 11 bits, with 29 bits, or as the
/// first 11 of 29 bits. `station` is added to the number, so that no two stations send the same identifier, as in
/// CANopen.
Frame any_frame(std::size_t station) {
    Frame frame{};
    const std::uint32_t number =
        *rc::gen::element<std::uint32_t>(0x000, 0x010, 0x120, 0x7F0) + static_cast<std::uint32_t>(station);
    frame.extended = *rc::gen::arbitrary<bool>();
    frame.id = frame.extended && *rc::gen::arbitrary<bool>() ? number << 18U : number;
    frame.remote = *rc::gen::inRange(0, 4) == 0;
    frame.length = *rc::gen::inRange<std::uint8_t>(0, 9);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        frame.data[i] = *rc::gen::element<std::uint8_t>(0x00, 0xFF, 0x1F, 0xAA, 0x83);
    }
    return frame;
}

constexpr std::size_t node_count = 3;
constexpr std::size_t most_gateways = 2;

std::vector<Act> any_acts(std::uint64_t us_per_bit) {
    std::vector<Act> acts(*rc::gen::inRange<std::size_t>(1, 40));
    for (Act& act : acts) {
        act.after_us =
            *rc::gen::oneOf(rc::gen::just<std::uint64_t>(0), rc::gen::inRange<std::uint64_t>(0, 150)) * us_per_bit +
            *rc::gen::inRange<std::uint64_t>(0, 3);
        act.deed = *rc::gen::weightedElement<Deed>({{12, Deed::send},
                                                    {3, Deed::put},
                                                    {4, Deed::send_by_door},
                                                    {1, Deed::switch_off},
                                                    {2, Deed::plug},
                                                    {1, Deed::unplug},
                                                    {2, Deed::filter},
                                                    {2, Deed::change_rate}});
        const bool of_gateway = act.deed == Deed::send_by_door || act.deed == Deed::plug || act.deed == Deed::unplug;
        act.which = *rc::gen::inRange<std::size_t>(0, of_gateway ? most_gateways : node_count);
        const bool by_door = act.deed == Deed::send_by_door;
        const std::size_t station = act.deed == Deed::put ? 7U : by_door ? 5U + act.which : act.which;
        // rarely, the identifier is one that station 0 may also send
        act.frame = any_frame(*rc::gen::inRange(0, 8) == 0 ? 0U : station);
        act.filters = any_filters();
        act.bit_us = *rc::gen::element<std::uint64_t>(0, 0, 1, 2, 8);
    }
    return acts;
}

NaiveFaults any_faults() {
    NaiveFaults faults;
    faults.corrupted = *rc::gen::element(0.0, 0.0, 0.3, 0.8);
    faults.lost = *rc::gen::element(0.0, 0.0, 0.3);
    faults.bus_off = *rc::gen::element(0.0, 0.0, 0.1);
    faults.seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
    return faults;
}

std::vector<std::string> lines_of(const std::vector<NaiveBus::Heard>& heard) {
    std::vector<std::string> lines;
    for (const NaiveBus::Heard& one : heard) {
        lines.push_back(fmt::format("{} {}", one.us, format_frame(one.frame)));
    }
    return lines;
}

std::vector<std::string> lines_of(const std::vector<std::pair<std::uint64_t, int>>& states) {
    std::vector<std::string> lines;
    for (const auto& [us, state] : states) {
        lines.push_back(fmt::format("{} {}", us, state));
    }
    return lines;
}

/// The in-process bus and the naive bus. Both get the same input.
class TwoBuses {
  public:
    TwoBuses(std::uint64_t us_per_bit, const NaiveFaults& faults)
        : bus_{"inproc", static_cast<std::uint32_t>(1000000U / us_per_bit),
               BusFaultRates{faults.corrupted, faults.lost, faults.bus_off, faults.seed}},
          naive_{us_per_bit, faults} {
        for (test::PlainNode* const node : nodes_) {
            bus_.attach(*node);
            naive_.add(node->name(), false);
        }
        bus_.listen([this](const BusFrame& one) {
            log_.push_back(fmt::format("{} {} {}", one.time.us, one.sender == nullptr ? "outside" : one.sender->name(),
                                       format_frame(one.frame)));
        });
    }

    /// Runs both buses from event to event. After each event, both must have the same next event.
    void run_to(std::uint64_t us) {
        for (Instant due = now_; due <= Instant{us}; due = bus_.next_deadline()) {
            bus_.advance(due);
            naive_.run_to(due.us);
            now_ = due;
            RC_ASSERT(bus_.next_deadline() == Instant{naive_.next_event()});
        }
        bus_.advance(Instant{us});
        naive_.run_to(us);
        now_ = Instant{us};
    }
    void let(const Act& act) {
        run_to(now_.us + act.after_us);
        switch (act.deed) {
            case Deed::send:
                nodes_[act.which]->waiting.push_back(act.frame);
                naive_.send(static_cast<int>(act.which) + 1, act.frame, now_.us);
                break;
            case Deed::put:
                bus_.put(act.frame, now_);
                naive_.send(0, act.frame, now_.us);
                break;
            case Deed::switch_off:
                bus_.switch_off(*nodes_[act.which], now_);
                naive_.switch_off(static_cast<int>(act.which) + 1, now_.us);
                break;
            case Deed::filter:
                nodes_[act.which]->accepted.clear();
                for (const NaiveBus::Filter& one : act.filters) {
                    nodes_[act.which]->accepted.push_back({one.id, one.mask, one.extended});
                }
                naive_.set_filters(static_cast<int>(act.which) + 1, act.filters);
                break;
            case Deed::change_rate:
                nodes_[act.which]->rate = act.bit_us == 0U ? 0U : static_cast<std::uint32_t>(1000000U / act.bit_us);
                naive_.set_bit_us(static_cast<int>(act.which) + 1, act.bit_us);
                break;
            default:
                let_gateway(act);
                break;
        }
        c_.tell();
        run_to(now_.us);
        for (const auto& [which, attached] : gateways_) {
            RC_ASSERT(bus_.is_sending(*attached.gateway) == naive_.is_sending(attached.number));
        }
    }
    void check() const {
        std::vector<std::string> expected;
        for (const NaiveBus::Sent& one : naive_.sent()) {
            const bool is_gateway = one.sender == "gateway";
            expected.push_back(
                fmt::format("{} {} {}", one.us, is_gateway ? "outside" : one.sender, format_frame(one.frame)));
        }
        RC_ASSERT(log_ == expected);
        for (std::size_t i = 0; i < node_count; ++i) {
            const NaiveBus::Station& same = naive_.station(static_cast<int>(i) + 1);
            RC_ASSERT(nodes_[i]->heard == lines_of(same.heard));
            RC_ASSERT(nodes_[i]->states == lines_of(same.states));
            RC_ASSERT(nodes_[i]->overruns == same.overruns);
        }
        for (const auto& [which, attached] : gateways_) {
            RC_ASSERT(attached.heard == lines_of(naive_.station(attached.number).heard));
        }
        RC_ASSERT(bus_.report(now_).bit_rate == 1000000U / naive_.bit_us());
        RC_ASSERT(bus_.report(now_).frames == expected.size());
        RC_ASSERT(bus_.report(now_).errors == naive_.errors());
        RC_ASSERT(bus_.report(now_).worst_latency.us == naive_.worst_latency());
        RC_ASSERT(std::abs(bus_.report(now_).load - naive_.load(now_.us)) < 1.0e-9);
    }

  private:
    struct AttachedGateway {
        std::unique_ptr<Gateway> gateway;
        int number{0};
        std::vector<std::string> heard;
    };

    void let_gateway(const Act& act) {
        const auto found = gateways_.find(act.which);
        if (found == gateways_.end()) {
            if (act.deed == Deed::plug) {
                AttachedGateway& attached = gateways_[act.which];
                attached.gateway =
                    std::make_unique<Gateway>("gateway", 100, [&attached](const Frame& frame, Instant at) {
                        attached.heard.push_back(fmt::format("{} {}", at.us, format_frame(frame)));
                    });
                bus_.attach_gateway(*attached.gateway);
                attached.number = naive_.add("gateway", true);
            }
        } else if (act.deed == Deed::unplug) {
            bus_.detach_gateway(*found->second.gateway);
            naive_.remove(found->second.number, now_.us);
            gateways_.erase(found);
        } else {
            found->second.gateway->put(act.frame);
            naive_.send(found->second.number, act.frame, now_.us);
        }
    }

    test::PlainNode a_{"a"};
    test::PlainNode b_{"b"};
    TellingNode c_{"c"};
    std::array<test::PlainNode*, node_count> nodes_{&a_, &b_, &c_};
    ArbitratedBus bus_;
    NaiveBus naive_;
    std::map<std::size_t, AttachedGateway> gateways_;
    std::vector<std::string> log_;
    Instant now_{};
};

}  // namespace

RC_GTEST_PROP(InprocBusLaw, BusAgreesWithTheNaiveModel, ()) {
    const auto us_per_bit = *rc::gen::element<std::uint64_t>(1, 2, 8);
    TwoBuses buses{us_per_bit, any_faults()};
    for (const Act& act : any_acts(us_per_bit)) {
        buses.let(act);
    }
    buses.run_to(200000);
    buses.check();
}

RC_GTEST_PROP(InprocBusLaw, FrameLengthInBitsEqualsTheCountOfTheNaiveModel, ()) {
    const Frame frame = any_frame(*rc::gen::inRange<std::size_t>(0, 8));
    RC_ASSERT(frame_bits(frame) == naive_frame_bits(frame));
}

RC_GTEST_PROP(InprocBusLaw, ArbitrationIsDecidedBitByBit, ()) {
    const Frame one = any_frame(*rc::gen::inRange<std::size_t>(0, 8));
    const Frame other = any_frame(*rc::gen::inRange<std::size_t>(0, 8));
    RC_ASSERT((arbitration_rank(one) < arbitration_rank(other)) ==
              (naive_arbitration_field(one) < naive_arbitration_field(other)));
}

}  // namespace canproof::host
