// SPDX-License-Identifier: Apache-2.0
// Rules of the in-process bus that single frames show: rounding of times, gateways, bus-off, error counters, bit rates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/input_error.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/bit_rate_vote.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::uint64_t length_of(const std::string& frame) {
    return frame_bits(parse_frame(frame, "test"));
}

/// A node that sends a frame when its bus-off state ends.
class ReturningNode final : public PlainNode {
  public:
    using PlainNode::PlainNode;

    void set_can_state(CanState state, Instant now) override {
        PlainNode::set_can_state(state, now);
        if (state == CanState::error_active) {
            send("081#");
        }
    }
};

/// A node that answers each frame at once.
class AnsweringNode final : public PlainNode {
  public:
    using PlainNode::PlainNode;

    void receive(const Frame& frame, Instant now) override {
        PlainNode::receive(frame, now);
        send("583#0102030405060708");
    }
};

/// A bus on which a gateway can break off its frames. Each broken frame is an error for the nodes that receive it.
class ErrorBench {
  public:
    explicit ErrorBench(const BusFaultRates& faults = {}) : bus{"inproc", 125000, faults} { bus.attach(node); }
    void pass_errors(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            Gateway gateway{"gateway", 1, {}};
            bus.attach_gateway(gateway);
            gateway.put(parse_frame("123#", "test"));
            bus.advance(now);
            bus.detach_gateway(gateway);
            pass(milliseconds(1));
        }
    }
    void pass_frames(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            bus.put(parse_frame("123#", "test"), now);
            pass(milliseconds(1));
        }
    }
    void pass(Duration time) {
        run_until(bus, now, now + time);
        now = now + time;
    }

    ArbitratedBus bus;
    PlainNode node{"node"};
    Instant now{};
};

/// Returns the bit rate, in bit/s, of a bus that had `present` before these votes.
std::uint32_t vote_on(const std::map<std::uint32_t, int>& votes, std::uint32_t present) {
    BitRateVote vote;
    for (const auto& [rate, count] : votes) {
        for (int i = 0; i < count; ++i) {
            vote.add(rate);
        }
    }
    return vote.outcome(present);
}

}  // namespace

TEST(ArbitratedRules, FrameTimeIsRoundedToNanosecondsAndItsEndUpToTheNextMicrosecond) {
    // At 999,990 bit/s, n bits take n × 1000.01 ns. For 50 to 66 bits, this is n us and 0.50 to 0.66 ns, rounded to n
    // us and 1 ns. So the frame ends in microsecond n + 1.
    ArbitratedBus bus{"inproc", 999990, {}};
    PlainNode a{"a"};
    PlainNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    const std::uint64_t bits = length_of("703#05");
    ASSERT_GE(bits, 50U);
    ASSERT_LE(bits, 66U);
    a.send("703#05");
    bus.advance(Instant{0});
    EXPECT_EQ(bus.next_deadline(), Instant{bits + 1});
    bus.advance(Instant{bits});
    EXPECT_THAT(b.heard, IsEmpty());
    bus.advance(Instant{bits + 1});
    EXPECT_THAT(b.heard, ElementsAre(fmt::format("{} 703#05", bits + 1)));
    EXPECT_EQ(bus.report(Instant{bits + 1}).worst_latency.us, bits + 1);
}

TEST(ArbitratedRules, GatewayWhosePauseEndsBetweenTwoMicrosecondsSendsAtTheLaterOne) {
    // At 10 Mbit/s, one bit takes 100 ns: 48 bits end at 4.8 us, the intermission at 5.1 us, the pause of the gateway
    // at 5.9 us. Its next frame starts at 6 us and ends at 10.8 us.
    ArbitratedBus bus{"inproc", 10000000, {}};
    PlainNode node{"node"};
    bus.attach(node);
    Gateway gateway{"gateway", 2, {}};
    bus.attach_gateway(gateway);
    ASSERT_EQ(length_of("100#"), 48U);
    gateway.put(parse_frame("100#", "test"));
    gateway.put(parse_frame("100#", "test"));
    bus.advance(Instant{0});
    for (const std::uint64_t us : {5U, 6U, 11U}) {
        EXPECT_EQ(bus.next_deadline(), Instant{us});
        bus.advance(Instant{us});
    }
    EXPECT_THAT(node.heard, ElementsAre("5 100#", "11 100#"));
}

TEST(ArbitratedRules, IdleGatewayIsNotSendingDuringTheFrameOfAnother) {
    ErrorBench bench;
    Gateway gateway{"gateway", 2, {}};
    bench.bus.attach_gateway(gateway);
    bench.node.send("703#05");
    bench.bus.advance(Instant{0});
    EXPECT_FALSE(bench.bus.is_sending(gateway));
}

TEST(ArbitratedRules, LatencyOfAnAnswerCountsFromTheEndOfItsRequest) {
    ArbitratedBus bus{"inproc", 125000, {}};
    PlainNode a{"a"};
    AnsweringNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    a.send("123#");
    run_until(bus, Instant{0}, Instant{20000});
    EXPECT_EQ(bus.report(Instant{20000}).worst_latency.us, (3 + length_of("583#0102030405060708")) * 8);
}

TEST(ArbitratedRules, NodeThatReturnsToTheBusTakesPartInTheArbitration) {
    ArbitratedBus bus{"inproc", 125000, {}};
    ReturningNode a{"a"};
    PlainNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    bus.switch_off(a, Instant{0});
    run_until(bus, Instant{0}, Instant{11263});
    b.send("703#05");
    run_until(bus, Instant{11264}, Instant{20000});  // 128 × 11 bits of 8 us after the begin of bus-off
    EXPECT_THAT(a.states, ElementsAre("0 3", "11264 0"));
    const std::uint64_t first = 11264 + length_of("081#") * 8;
    EXPECT_THAT(b.heard, ElementsAre(fmt::format("{} 081#", first)));
    EXPECT_THAT(a.heard, ElementsAre(fmt::format("{} 703#05", first + (3 + length_of("703#05")) * 8)));
}

TEST(ArbitratedRules, DurationOfBusOffFollowsTheBitRateAtItsStart) {
    ArbitratedBus bus{"inproc", 125000, {}};
    PlainNode a{"a"};
    PlainNode b{"b"};
    PlainNode c{"c"};
    for (PlainNode* const node : {&a, &b, &c}) {
        node->rate = 125000;
        bus.attach(*node);
    }
    bus.advance(Instant{0});
    bus.switch_off(a, Instant{0});  // node a is bus-off for 1408 bits, at 8 us per bit
    a.rate = b.rate = c.rate = 1000000;
    bus.advance(Instant{100});
    bus.switch_off(b, Instant{200});  // node b is bus-off for 1408 bits, now at 1 us per bit
    bus.advance(Instant{1608});
    EXPECT_THAT(b.states, ElementsAre("200 3", "1608 0"));
    EXPECT_THAT(a.states, ElementsAre("0 3"));
    bus.advance(Instant{11264});
    EXPECT_THAT(a.states, ElementsAre("0 3", "11264 0"));
}

TEST(ArbitratedRules, EachBusOffStateOfANodeLasts1408Bits) {
    ArbitratedBus bus{"inproc", 125000, {}};
    PlainNode a{"a"};
    bus.attach(a);
    for (const std::uint64_t begin : {1000U, 20000U, 50000U}) {
        a.states.clear();
        const std::string off = fmt::format("{} 3", begin);
        bus.switch_off(a, Instant{begin});
        bus.advance(Instant{begin + 11263});
        EXPECT_THAT(a.states, ElementsAre(off));
        bus.advance(Instant{begin + 11264});  // 128 × 11 bits of 8 us
        EXPECT_THAT(a.states, ElementsAre(off, fmt::format("{} 0", begin + 11264)));
    }
}

TEST(ArbitratedRules, BusOffIsReportedEvenToANodeThatHasAnOverrun) {
    ErrorBench bench{BusFaultRates{0.0, 0.5, 0.0, 1}};
    for (int i = 0; i < 100 && (bench.node.overruns.empty() || !bench.node.overruns.back()); ++i) {
        bench.pass_frames(1);
    }
    ASSERT_TRUE(!bench.node.overruns.empty() && bench.node.overruns.back());
    bench.bus.switch_off(bench.node, bench.now);
    EXPECT_THAT(bench.node.states, ElementsAre(fmt::format("{} 3", bench.now.us)));
}

TEST(ArbitratedRules, EachReceivedFrameReducesTheReceiveErrorCounterByOne) {
    ErrorBench bench;
    bench.pass_errors(95);
    bench.pass_frames(95);
    bench.pass_errors(95);
    EXPECT_THAT(bench.node.states, IsEmpty());
    bench.pass_errors(1);
    EXPECT_THAT(bench.node.states, SizeIs(1));  // 96 errors lead to the warning state
    const Instant begin = bench.now;
    bench.pass_frames(1);
    const Instant end = begin + Duration{length_of("123#") * 8};
    EXPECT_EQ(bench.node.states.back(), fmt::format("{} 0", end.us));  // 95 errors are below the warning limit
}

TEST(ArbitratedRules, DisconnectedNodeCountsNoErrors) {
    ErrorBench bench;
    PlainNode other{"other"};
    PlainNode fast{"fast"};
    bench.bus.attach(other);
    bench.bus.attach(fast);
    bench.node.rate = other.rate = 125000;
    fast.rate = 250000;
    bench.pass_errors(96);
    EXPECT_THAT(bench.node.states, SizeIs(1));
    EXPECT_THAT(fast.states, IsEmpty());
}

TEST(ArbitratedRules, FrameThatAReceiverLosesDoesNotReduceItsErrorCounter) {
    ErrorBench bench{BusFaultRates{0.0, 0.5, 0.0, 1}};
    bench.pass_errors(95);
    bench.pass_frames(40);
    const std::size_t received = bench.node.heard.size();
    ASSERT_GT(received, 0U);
    ASSERT_LT(received, 40U);
    bench.pass_errors(received);
    EXPECT_THAT(bench.node.states, IsEmpty());  // 95 errors are below the warning limit
    bench.pass_errors(1);
    EXPECT_THAT(bench.node.states, SizeIs(1));
}

TEST(ArbitratedRules, LoadOfAnEarlierTimeCountsTheFramesUpToThatTime) {
    ErrorBench bench;
    bench.node.send("703#05");
    bench.node.send("703#05");
    const std::uint64_t end = length_of("703#05") * 8;
    bench.bus.advance(Instant{0});
    bench.bus.advance(Instant{end});
    bench.bus.advance(Instant{end + 3 * 8});  // the second frame starts
    EXPECT_DOUBLE_EQ(bench.bus.report(Instant{100}).load, 1.0);
}

TEST(ArbitratedRules, LoadAfterIdleSecondsIsThatOfTheLastSecond) {
    ErrorBench bench;
    bench.pass(milliseconds(3000));
    bench.node.send("703#05");
    bench.pass(milliseconds(100));
    const double busy_us = static_cast<double>((length_of("703#05") + 3) * 8);
    EXPECT_NEAR(bench.bus.report(bench.now).load, busy_us / 1.0e6, 1.0e-9);
}

TEST(ArbitratedRules, FullBusHasALoadOfOneWhenABitLastsAFractionOfAMicrosecond) {
    ArbitratedBus bus{"inproc", 800000, {}};  // a bit lasts 1.25 us
    PlainNode node{"node"};
    bus.attach(node);
    for (int i = 0; i < 200; ++i) {
        node.send("703#05");
    }
    run_until(bus, Instant{0}, Instant{10000});  // 200 frames of at least 50 bits last longer than 10 ms
    EXPECT_NEAR(bus.report(Instant{10000}).load, 1.0, 1.0e-9);
}

TEST(ArbitratedRules, UpTo256FramesFromTheUserWaitForTheBus) {
    ErrorBench bench;
    for (int i = 0; i < 256; ++i) {
        ASSERT_TRUE(bench.bus.put(parse_frame("123#", "test"), Instant{0})) << i;
    }
    EXPECT_FALSE(bench.bus.put(parse_frame("123#", "test"), Instant{0}));
}

TEST(BitRateVote, BitRateWithMostVotesWins) {
    EXPECT_EQ(vote_on({{125000, 1}, {250000, 3}, {500000, 2}}, 125000), 250000U);
    EXPECT_EQ(vote_on({{125000, 1}, {250000, 2}, {500000, 3}}, 125000), 500000U);
    EXPECT_EQ(vote_on({{125000, 1}}, 500000), 125000U);  // nobody votes for the present rate
}

TEST(BitRateVote, PresentRateStaysOnATieAndWithoutAVote) {
    EXPECT_EQ(vote_on({{125000, 2}, {250000, 2}}, 250000), 250000U);
    EXPECT_EQ(vote_on({{0, 2}}, 250000), 250000U);
}

TEST(ArbitratedRules, GatewaysDoNotCountTowardsTheLimitOf127Nodes) {
    ArbitratedBus bus{"inproc", 125000, BusFaultRates{}};
    Gateway first{"first", 1, {}};
    Gateway second{"second", 1, {}};
    bus.attach_gateway(first);
    bus.attach_gateway(second);
    std::deque<PlainNode> nodes(ArbitratedBus::most_nodes);
    for (PlainNode& node : nodes) {
        bus.attach(node);
    }
    PlainNode last{"last"};
    EXPECT_THROW(bus.attach(last), InputError);
    bus.detach_gateway(first);
    EXPECT_THROW(bus.attach(last), InputError);
}

TEST(ArbitratedRules, OneLateCallOfAdvanceHandlesEachEventAtItsOwnTime) {
    ArbitratedBus bus{"inproc", 125000, BusFaultRates{0.0, 0.0, 0.9, 1}};  // with this seed, a goes bus-off at once
    PlainNode a{"a"};
    PlainNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    a.send("703#05");
    bus.advance(Instant{0});
    bus.advance(Instant{100000});
    const std::uint64_t end = 8U * length_of("703#05");
    // 128 × 11 bits of 8 us after the end of the frame
    EXPECT_THAT(a.states, ElementsAre(fmt::format("{} 3", end), fmt::format("{} 0", end + 11264U)));
    EXPECT_THAT(b.heard, ElementsAre(fmt::format("{} 703#05", end)));
    EXPECT_EQ(bus.next_deadline(), never);
}

}  // namespace canproof::host::test
