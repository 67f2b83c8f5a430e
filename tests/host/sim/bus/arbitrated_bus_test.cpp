// SPDX-License-Identifier: Apache-2.0
// The in-process bus behaves as CAN does: arbitration, frame times, faults, recovery, bit rates, and repeatable runs.
#include "host/sim/bus/arbitrated_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/input_error.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Three plain nodes at 125 kbit/s, where one bit lasts 8 us.
class ArbitratedBusTest : public testing::Test {
  protected:
    void start(const BusFaultRates& faults = {}) {
        bus = std::make_unique<ArbitratedBus>("inproc", 125000, faults);
        for (PlainNode* node : {&a, &b, &c}) {
            bus->attach(*node);
        }
        bus->listen([this](const BusFrame& frame) {
            log.push_back(fmt::format("{} {}", frame.sender == nullptr ? "outside" : frame.sender->name(),
                                      format_frame(frame.frame)));
        });
    }

    PlainNode a{"a"};
    PlainNode b{"b"};
    PlainNode c{"c"};
    std::unique_ptr<ArbitratedBus> bus;
    std::vector<std::string> log;
};

std::uint64_t time_of(const std::string& frame, unsigned us_per_bit = 8) {
    return std::uint64_t{frame_bits(parse_frame(frame, "test"))} * us_per_bit;
}

}  // namespace

TEST_F(ArbitratedBusTest, FrameArrivesWithItsLastBitAtEveryOtherNode) {
    start();
    a.send("703#05");
    run_until(*bus, Instant{1000}, Instant{5000});
    const std::string expected = fmt::format("{} 703#05", 1000 + time_of("703#05"));
    EXPECT_THAT(b.heard, ElementsAre(expected));
    EXPECT_THAT(c.heard, ElementsAre(expected));
    EXPECT_THAT(a.heard, IsEmpty());
}

TEST_F(ArbitratedBusTest, LowestIdentifierGoesFirstWithThreeBitsBetweenFrames) {
    start();
    a.send("703#05");
    b.send("183#AABB");
    c.send("083#0010110000000000");
    run_until(*bus, Instant{0}, Instant{10000});
    EXPECT_THAT(log, ElementsAre("c 083#0010110000000000", "b 183#AABB", "a 703#05"));
    const std::uint64_t first = time_of("083#0010110000000000");
    const std::uint64_t second = first + 3 * 8 + time_of("183#AABB");
    const std::uint64_t third = second + 3 * 8 + time_of("703#05");
    EXPECT_EQ(a.heard.back(), fmt::format("{} 183#AABB", second));
    EXPECT_EQ(b.heard.back(), fmt::format("{} 703#05", third));
}

TEST_F(ArbitratedBusTest, RunningFrameIsNotInterrupted) {
    start();
    a.send("703#05");
    bus->advance(Instant{0});
    b.send("000#0100");
    run_until(*bus, Instant{8}, Instant{10000});
    EXPECT_THAT(log, ElementsAre("a 703#05", "b 000#0100"));
}

TEST_F(ArbitratedBusTest, ReportCountsLoadAndWorstLatency) {
    start();
    a.send("703#05");
    b.send("183#AABB");
    run_until(*bus, Instant{0}, Instant{1000000});
    const std::uint64_t first = time_of("183#AABB");
    const std::uint64_t second = time_of("703#05");
    const BusReport report = bus->report(Instant{1000000});
    EXPECT_EQ(report.frames, 2U);
    EXPECT_EQ(report.errors, 0U);
    // in one second, the bus is busy during the two frames and the 3 bits of intermission after each
    EXPECT_NEAR(report.load, static_cast<double>(first + second + 6 * 8) / 1.0e6, 1.0e-9);
    EXPECT_EQ(report.worst_latency.us, first + 3 * 8 + second);
    EXPECT_EQ(report.bit_rate, 125000U);
    EXPECT_DOUBLE_EQ(bus->report(Instant{3000000}).load, 0.0);
}

TEST_F(ArbitratedBusTest, FullBusHasALoadOfOne) {
    start();
    for (int i = 0; i < 3000; ++i) {
        a.send("000#");
    }
    run_until(*bus, Instant{0}, Instant{1000000});
    EXPECT_NEAR(bus->report(Instant{1000000}).load, 1.0, 1.0e-6);
}

TEST_F(ArbitratedBusTest, RoundingErrorsOfTheBitTimeDoNotAccumulate) {
    // At 800 kbit/s, one bit lasts 1.25 us. The test sends 1000 frames of n bits with 999 intermissions.
    bus = std::make_unique<ArbitratedBus>("inproc", 800000, BusFaultRates{});
    bus->attach(a);
    bus->attach(b);
    for (int i = 0; i < 1000; ++i) {
        a.send("703#05");
    }
    run_until(*bus, Instant{0}, Instant{1000000});
    const std::uint64_t bits = 1000U * frame_bits(parse_frame("703#05", "test")) + 999U * 3U;
    EXPECT_EQ(b.heard.back(), fmt::format("{} 703#05", (bits * 5 + 3) / 4));
}

TEST_F(ArbitratedBusTest, FrameFromAGatewayReachesAllNodes) {
    start();
    ASSERT_TRUE(bus->put(parse_frame("000#0100", "test"), Instant{0}));
    run_until(*bus, Instant{0}, Instant{10000});
    EXPECT_THAT(log, ElementsAre("outside 000#0100"));
    EXPECT_THAT(a.heard, SizeIs(1));
    EXPECT_THAT(c.heard, SizeIs(1));
}

TEST_F(ArbitratedBusTest, FloodingGatewayLeavesTheBusToOthersAfterEachFrame) {
    start();
    Gateway flood{"flood", 64, {}};
    bus->attach_gateway(flood);
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(flood.put(parse_frame("000#", "test")));
    }
    a.send("77F#05");
    a.send("77F#05");
    run_until(*bus, Instant{0}, Instant{50000});
    // 000h wins each arbitration, but the gateway takes part in none during eight bit times after its own frame.
    EXPECT_EQ(log[0], "outside 000#");
    EXPECT_EQ(log[1], "a 77F#05");
    EXPECT_EQ(log[2], "outside 000#");
    EXPECT_EQ(log[3], "a 77F#05");
    EXPECT_THAT(log, SizeIs(52));
}

TEST_F(ArbitratedBusTest, FrameOfADetachedGatewayIsNotDelivered) {
    start();
    auto gateway = std::make_unique<Gateway>("gateway", 4, Gateway::Outlet{});
    bus->attach_gateway(*gateway);
    gateway->put(parse_frame("123#", "test"));
    bus->advance(Instant{0});
    bus->detach_gateway(*gateway);
    gateway.reset();
    a.send("703#05");
    run_until(*bus, Instant{100}, Instant{10000});
    EXPECT_THAT(log, ElementsAre("a 703#05"));
}

TEST_F(ArbitratedBusTest, CorruptedFrameIsSentAgainAndCounted) {
    BusFaultRates faults;
    faults.corrupted = 0.5;
    faults.seed = 3;
    start(faults);
    for (int i = 0; i < 20; ++i) {
        a.send(fmt::format("{:03X}#05", 0x700 + i));
    }
    run_until(*bus, Instant{0}, Instant{1000000});
    const BusReport report = bus->report(Instant{1000000});
    EXPECT_EQ(report.frames, 20U);
    EXPECT_GT(report.errors, 5U);
    ASSERT_THAT(b.heard, SizeIs(20));
    for (int i = 0; i < 20; ++i) {
        EXPECT_THAT(b.heard[static_cast<std::size_t>(i)], testing::HasSubstr(fmt::format("{:03X}#05", 0x700 + i)));
    }
}

TEST_F(ArbitratedBusTest, LostFrameIsAnOverrunOfAReceiverUntilTheNextFrameArrives) {
    BusFaultRates faults;
    faults.lost = 0.3;
    faults.seed = 5;
    start(faults);
    for (int i = 0; i < 100; ++i) {
        a.send("703#05");
    }
    run_until(*bus, Instant{0}, Instant{1000000});
    const auto told = [](const PlainNode& node) {
        return static_cast<std::size_t>(std::count(node.overruns.begin(), node.overruns.end(), true));
    };
    EXPECT_GT(told(b), 0U);
    EXPECT_GT(told(c), 0U);
    EXPECT_LT(b.heard.size(), 100U);
    EXPECT_TRUE(b.overruns.front());  // the first call reports the begin of an overrun
    for (std::size_t i = 1; i < b.overruns.size(); ++i) {
        EXPECT_NE(b.overruns[i], b.overruns[i - 1]);
    }
}

TEST_F(ArbitratedBusTest, BusOffLasts128Times11Bits_AndEndsErrorActive) {
    start();
    run_until(*bus, Instant{0}, Instant{1000});
    bus->switch_off(a, Instant{1000});
    b.send("703#05");
    a.send("083#");  // sent while the node is off the bus
    run_until(*bus, Instant{1000}, Instant{100000});
    // bus-off lasts 128 × 11 bits × 8 us = 11264 us
    EXPECT_THAT(a.states, ElementsAre("1000 3", "12264 0"));
    EXPECT_THAT(a.heard, IsEmpty());
    EXPECT_THAT(log, ElementsAre("b 703#05", "a 083#"));
    EXPECT_EQ(b.heard.back(), fmt::format("{} 083#", 12264 + time_of("083#")));
}

TEST_F(ArbitratedBusTest, FrameOfANodeThatGoesBusOffIsLostWithAnErrorFrame) {
    start();
    a.send("083#");
    bus->advance(Instant{0});
    bus->switch_off(a, Instant{80});
    b.send("703#05");
    run_until(*bus, Instant{80}, Instant{100000});
    // an error frame of 20 bits and an intermission of 3 bits, 8 us each, then the frame of b
    EXPECT_THAT(c.heard, ElementsAre(fmt::format("{} 703#05", 80 + 23 * 8 + time_of("703#05"))));
    // 128 × 11 bits of 8 us, whatever frame was on the bus when the node went bus-off
    EXPECT_THAT(a.states, ElementsAre("80 3", "11344 0"));
    EXPECT_EQ(bus->report(Instant{100000}).errors, 1U);
}

TEST_F(ArbitratedBusTest, CorruptedFrameOfANodeThatWentBusOffIsNotSentLater) {
    BusFaultRates faults;
    faults.corrupted = 0.9;
    faults.seed = 1;  // with this seed, the first frame is corrupted
    start(faults);
    a.send("083#");
    run_until(*bus, Instant{0}, Instant{2000});
    ASSERT_GT(bus->report(Instant{2000}).errors, 0U);
    ASSERT_THAT(log, IsEmpty());
    bus->switch_off(a, Instant{2000});
    run_until(*bus, Instant{2000}, Instant{1000000});
    EXPECT_THAT(log, IsEmpty());
}

TEST_F(ArbitratedBusTest, LatencyOfARepeatedFrameCountsFromItsFirstAttempt) {
    std::uint64_t errors = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        BusFaultRates faults;
        faults.corrupted = 0.5;
        faults.seed = seed;
        ArbitratedBus one{"inproc", 125000, faults};
        PlainNode x{"x"};
        PlainNode y{"y"};
        one.attach(x);
        one.attach(y);
        x.send("083#");
        run_until(one, Instant{100}, Instant{1000000});
        ASSERT_THAT(y.heard, SizeIs(1));
        EXPECT_EQ(fmt::format("{} 083#", 100 + one.report(Instant{1000000}).worst_latency.us), y.heard[0]);
        errors += one.report(Instant{1000000}).errors;
    }
    EXPECT_GT(errors, 0U);  // at least one frame was corrupted
}

TEST_F(ArbitratedBusTest, LatencyOfAFrameIsNotThatOfTheNextQueuedFrame) {
    start();
    b.send("000#");
    a.send("083#");
    bus->advance(Instant{0});
    const std::uint64_t first = time_of("000#") + 3 * 8;
    run_until(*bus, Instant{0}, Instant{first});  // 083h begins after the first frame and its intermission of 24 us
    a.send("084#");
    run_until(*bus, Instant{first}, Instant{100000});
    EXPECT_EQ(bus->report(Instant{100000}).worst_latency.us, first + time_of("083#"));
}

TEST_F(ArbitratedBusTest, GatewayDetachedDuringItsFrameLeavesAnErrorFrame) {
    start();
    Gateway first{"first", 4, {}};
    Gateway second{"second", 4, {}};
    bus->attach_gateway(first);
    bus->attach_gateway(second);
    second.put(parse_frame("123#", "test"));
    bus->advance(Instant{0});
    bus->detach_gateway(first);  // this gateway does not send, so the frame continues
    run_until(*bus, Instant{0}, Instant{1000});
    EXPECT_THAT(log, ElementsAre("outside 123#"));
    second.put(parse_frame("123#", "test"));
    run_until(*bus, Instant{1000}, Instant{1080});
    bus->detach_gateway(second);
    a.send("703#05");
    run_until(*bus, Instant{1080}, Instant{10000});
    EXPECT_EQ(b.heard.back(), fmt::format("{} 703#05", 1080 + 23 * 8 + time_of("703#05")));
    EXPECT_EQ(bus->report(Instant{10000}).errors, 1U);
}

TEST_F(ArbitratedBusTest, ErrorCountersLeadToWarningErrorPassiveAndBusOff) {
    FaultConfinement one;
    for (int i = 0; i < 12; ++i) {
        EXPECT_EQ(one.state(), CanState::error_active) << i;  // the counter is 0, 8 … 88
        one.transmit_failed();
    }
    EXPECT_EQ(one.state(), CanState::warning);  // the counter is 96
    for (int i = 0; i < 4; ++i) {
        one.transmit_failed();
    }
    EXPECT_EQ(one.state(), CanState::error_passive);  // the counter is 128
    one.transmitted();
    EXPECT_EQ(one.state(), CanState::warning);  // the counter is 127
    for (int i = 0; i < 17; ++i) {
        one.transmit_failed();
    }
    EXPECT_EQ(one.state(), CanState::bus_off);  // the counter is 263
    one.recover();
    EXPECT_EQ(one.state(), CanState::error_active);
    for (int i = 0; i < 130; ++i) {
        one.receive_failed();
    }
    EXPECT_EQ(one.state(), CanState::error_passive);
    one.received();
    EXPECT_EQ(one.receive_errors(), 119U);
    one.switch_off();
    one.recover();
    EXPECT_EQ(one.state(), CanState::error_active);  // both error counters start at 0 again
    EXPECT_EQ(one.receive_errors(), 0U);
}

TEST_F(ArbitratedBusTest, NodeAtAnotherBitRateIsDisconnectedUntilMostNodesHaveItsBitRate) {
    start();
    std::vector<std::string> notices;
    bus->on_notice([&](const std::string& text) { notices.push_back(text); });
    a.rate = b.rate = c.rate = 125000;
    run_until(*bus, Instant{0}, Instant{100});
    a.rate = 250000;
    a.send("701#05");
    b.send("702#05");
    run_until(*bus, Instant{100}, Instant{10000});
    EXPECT_THAT(log, ElementsAre("b 702#05"));
    EXPECT_THAT(a.heard, IsEmpty());
    b.rate = 250000;
    run_until(*bus, Instant{10000}, Instant{20000});
    EXPECT_EQ(bus->report(Instant{20000}).bit_rate, 250000U);
    EXPECT_THAT(log, ElementsAre("b 702#05", "a 701#05"));
    EXPECT_EQ(b.heard.back(), fmt::format("{} 701#05", 10000 + time_of("701#05", 4)));
    EXPECT_THAT(c.heard, SizeIs(1));  // the bus still has 125 kbit/s
    EXPECT_THAT(notices,
                ElementsAre("a: LSS sets 250000 bit/s; the bus has another bit rate; the device is unreachable",
                            "b: LSS sets 250000 bit/s; the bus has this bit rate"));
}

TEST_F(ArbitratedBusTest, BusTakes127NodesAndNoMore) {
    start();
    std::vector<std::unique_ptr<PlainNode>> others;
    for (int i = 4; i <= 127; ++i) {
        others.push_back(std::make_unique<PlainNode>("n" + std::to_string(i)));
        bus->attach(*others.back());
    }
    PlainNode last{"last"};
    EXPECT_THROW(bus->attach(last), InputError);
    for (auto& node : others) {
        node->send("703#05");
    }
    run_until(*bus, Instant{0}, Instant{1000000});
    EXPECT_EQ(bus->report(Instant{1000000}).frames, 124U);
    EXPECT_THAT(a.heard, SizeIs(124));
}

TEST_F(ArbitratedBusTest, SameSeedGivesTheSameTrafficAndAnotherSeedDoesNot) {
    const auto traffic = [](std::uint64_t seed) {
        BusFaultRates faults;
        faults.corrupted = 0.2;
        faults.lost = 0.1;
        faults.bus_off = 0.02;
        faults.seed = seed;
        ArbitratedBus one{"inproc", 500000, faults};
        PlainNode x{"x"};
        PlainNode y{"y"};
        one.attach(x);
        one.attach(y);
        for (int i = 0; i < 200; ++i) {
            x.send(fmt::format("181#{:02X}", i));
            y.send(fmt::format("182#{:02X}", i));
        }
        run_until(one, Instant{0}, Instant{1000000});
        std::vector<std::string> all = x.heard;
        all.insert(all.end(), y.heard.begin(), y.heard.end());
        all.insert(all.end(), x.states.begin(), x.states.end());
        return all;
    };
    EXPECT_EQ(traffic(7), traffic(7));
    EXPECT_NE(traffic(7), traffic(8));
}

TEST(BusFaultText, EachFaultRateIsReadAndOtherTextIsRefused) {
    const BusFaultRates rates = parse_bus_faults("corrupted=0.25,lost=0.5,bus-off=0.125,seed=42");
    EXPECT_DOUBLE_EQ(rates.corrupted, 0.25);
    EXPECT_DOUBLE_EQ(rates.lost, 0.5);
    EXPECT_DOUBLE_EQ(rates.bus_off, 0.125);
    EXPECT_EQ(rates.seed, 42U);
    for (const char* wrong : {"corrupted", "corrupted=1", "lost=-0.1", "lost=nan", "seed=x", "late=0.1", "seed="}) {
        EXPECT_THROW(parse_bus_faults(wrong), InputError) << wrong;
    }
}

}  // namespace canproof::host::test
