// SPDX-License-Identifier: Apache-2.0
// The load and the bit rate that the in-process bus reports, compared with numbers of bits that are counted by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint64_t us_per_bit = 8;
constexpr std::uint64_t second = 1000000;
constexpr double exact = 1.0e-9;

std::uint64_t time_of(const std::string& frame) {
    return std::uint64_t{frame_bits(parse_frame(frame, "test"))} * us_per_bit;
}

/// Two nodes at 125 kbit/s, where one bit lasts 8 us.
class BusLoad : public testing::Test {
  protected:
    BusLoad() {
        bus.attach(a);
        bus.attach(b);
        bus.on_notice([this](const std::string& text) { notices.push_back(text); });
    }
    double load_at(std::uint64_t us) { return bus.report(Instant{us}).load; }

    PlainNode a{"a"};
    PlainNode b{"b"};
    ArbitratedBus bus{"inproc", 125000, {}};
    std::vector<std::string> notices;
};

}  // namespace

TEST_F(BusLoad, LoadOfARunningFrameCountsFromItsStart) {
    run_until(bus, Instant{0}, Instant{100});
    a.send("703#05");
    bus.advance(Instant{100});
    EXPECT_DOUBLE_EQ(load_at(0), 0.0);    // at time 0 no time has passed
    EXPECT_DOUBLE_EQ(load_at(100), 0.0);  // the frame begins at 100 us
    EXPECT_NEAR(load_at(200), 0.5, exact);
    EXPECT_NEAR(load_at(400), 0.75, exact);
}

TEST_F(BusLoad, LoadOfTheLastSecondCountsThePartOfAFrameWithinIt) {
    a.send("703#05");
    run_until(bus, Instant{0}, Instant{second});
    const std::uint64_t busy = time_of("703#05") + 3 * us_per_bit;
    EXPECT_NEAR(load_at(second), static_cast<double>(busy) / 1.0e6, exact);
    bus.advance(Instant{second + 100});  // 100 us of the frame are before the last second
    EXPECT_NEAR(load_at(second + 100), static_cast<double>(busy - 100) / 1.0e6, exact);
    bus.advance(Instant{second + busy - 1});
    EXPECT_NEAR(load_at(second + busy - 1), 1.0e-6, exact);
    bus.advance(Instant{second + busy});
    EXPECT_DOUBLE_EQ(load_at(second + busy), 0.0);
    EXPECT_EQ(bus.report(Instant{second + busy}).frames, 1U);
}

TEST_F(BusLoad, LoadIsOneDuringAFrameLongerThanASecond) {
    // At 10 bit/s, the shortest frame takes more than four seconds.
    ArbitratedBus slow{"inproc", 10, {}};
    slow.attach(a);
    a.send("703#05");
    slow.advance(Instant{0});
    EXPECT_NEAR(slow.report(Instant{3 * second}).load, 1.0, exact);
}

TEST_F(BusLoad, LoadIncludesInterruptedFrames) {
    a.send("703#05");
    bus.advance(Instant{0});
    bus.switch_off(a, Instant{80});
    run_until(bus, Instant{80}, Instant{second});
    // 80 us of the frame, 20 bits of error frame, 3 bits of intermission
    EXPECT_NEAR(load_at(second), (80.0 + 23.0 * 8.0) / 1.0e6, exact);
    EXPECT_EQ(bus.report(Instant{second}).frames, 0U);
}

TEST_F(BusLoad, LoadIsExactWhenReadRarely) {
    for (int i = 0; i < 100; ++i) {
        a.send("703#05");
    }
    run_until(bus, Instant{0}, Instant{second});
    const double busy = static_cast<double>(100 * (time_of("703#05") + 3 * us_per_bit));
    bus.advance(Instant{second});
    EXPECT_NEAR(load_at(second), busy / 1.0e6, exact);
    bus.advance(Instant{3 * second});
    EXPECT_DOUBLE_EQ(load_at(3 * second), 0.0);
}

TEST(BusBitRate, BitRateIs125000ByDefault) {
    ArbitratedBus bus{"inproc", 0, {}};
    EXPECT_EQ(bus.report(Instant{0}).bit_rate, 125000U);
    EXPECT_EQ(bus.interface(), "inproc");
    EXPECT_THAT(bus.watches(), IsEmpty());
    EXPECT_EQ(bus.poll(Instant{5}), Instant{5});
}

TEST(BusBitRate, BitTimeIsRoundedToTheNearestNanosecond) {
    // At 300 kbit/s, one bit lasts 3333.33 ns. The time of a frame and that of its intermission are rounded separately.
    ArbitratedBus bus{"inproc", 300000, {}};
    PlainNode a{"a"};
    PlainNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    a.send("703#05");
    a.send("703#05");
    run_until(bus, Instant{0}, Instant{100000});
    const std::uint64_t bits = frame_bits(parse_frame("703#05", "test"));
    const std::uint64_t frame_ns = (bits * 1000000000U + 150000U) / 300000U;
    const std::uint64_t all_ns = 2U * frame_ns + 10000U;  // two frames, and 3 bits of intermission, which take 10 us
    EXPECT_EQ(b.heard.front(), fmt::format("{} 703#05", (frame_ns + 999U) / 1000U));
    EXPECT_EQ(b.heard.back(), fmt::format("{} 703#05", (all_ns + 999U) / 1000U));
}

TEST_F(BusLoad, BitRateFollowsTheMajorityAndStaysOnATie) {
    a.rate = 125000;
    b.rate = 250000;
    run_until(bus, Instant{0}, Instant{100});
    EXPECT_EQ(bus.report(Instant{100}).bit_rate, 125000U);
    PlainNode c{"c"};
    c.rate = 250000;
    bus.attach(c);
    run_until(bus, Instant{100}, Instant{200});
    EXPECT_EQ(bus.report(Instant{200}).bit_rate, 250000U);
    EXPECT_THAT(notices, IsEmpty());  // no node has changed its rate
}

TEST_F(BusLoad, BitRateOfTheNodesReplacesThatOfTheBus) {
    a.rate = 500000;
    run_until(bus, Instant{0}, Instant{100});
    EXPECT_EQ(bus.report(Instant{100}).bit_rate, 500000U);
    a.send("703#05");
    run_until(bus, Instant{100}, Instant{10000});
    EXPECT_EQ(b.heard.size(), 1U);  // node b has no bit rate of its own, so it receives at any rate
}

TEST_F(BusLoad, BitRateDoesNotChangeDuringAFrame) {
    a.rate = b.rate = 125000;
    a.send("703#05");
    bus.advance(Instant{0});
    a.rate = b.rate = 250000;
    bus.advance(Instant{100});
    EXPECT_EQ(bus.report(Instant{100}).bit_rate, 125000U);
    run_until(bus, Instant{100}, Instant{10000});
    EXPECT_EQ(bus.report(Instant{10000}).bit_rate, 250000U);
    EXPECT_THAT(notices, ElementsAre("a: LSS sets 250000 bit/s; the bus has this bit rate",
                                     "b: LSS sets 250000 bit/s; the bus has this bit rate"));
}

TEST_F(BusLoad, DisconnectedNodeIsConnectedAgainWhenItAcceptsAnyBitRate) {
    a.rate = 250000;
    b.rate = 125000;
    run_until(bus, Instant{0}, Instant{100});
    a.rate = 0;
    a.send("703#05");
    run_until(bus, Instant{100}, Instant{10000});
    EXPECT_EQ(b.heard.size(), 1U);
}

TEST_F(BusLoad, NoDeadlineIsSetWhileNoNodeMaySend) {
    EXPECT_EQ(bus.next_deadline(), never);
    a.rate = b.rate = 125000;
    a.send("703#05");
    a.rate = 250000;
    bus.advance(Instant{0});
    // one vote each: the bus keeps 125 kbit/s, so the frame of a, at 250 kbit/s, is not sent
    EXPECT_EQ(bus.next_deadline(), never);
    a.rate = 125000;
    EXPECT_EQ(bus.next_deadline(), Instant{0});
}

TEST_F(BusLoad, GatewayWaitsEightBitsAfterItsFrameAndANodeDoesNot) {
    Gateway gateway{"gateway", 4, {}};
    bus.attach_gateway(gateway);
    gateway.put(parse_frame("123#", "test"));
    gateway.put(parse_frame("124#", "test"));
    bus.advance(Instant{0});
    const Instant end{time_of("123#")};
    EXPECT_EQ(bus.next_deadline(), end);
    bus.advance(end);
    EXPECT_EQ(bus.next_deadline(), end + Duration{11 * us_per_bit});
    a.send("703#05");
    EXPECT_EQ(bus.next_deadline(), end + Duration{3 * us_per_bit});
}

TEST_F(BusLoad, FrameQueuedDuringTheIntermissionWaitsForItsEnd) {
    a.send("123#");
    bus.advance(Instant{0});
    const std::uint64_t end = time_of("123#");
    bus.advance(Instant{end});
    b.send("703#05");
    bus.advance(Instant{end + 23});
    bus.advance(Instant{end + 24});
    EXPECT_EQ(bus.next_deadline(), Instant{end + 24 + time_of("703#05")});
}

TEST_F(BusLoad, UnattachedGatewayIsNotSendingAndMayBeDetached) {
    Gateway stranger{"stranger", 4, {}};
    stranger.put(parse_frame("123#", "test"));
    a.send("703#05");
    bus.advance(Instant{0});
    EXPECT_FALSE(bus.is_sending(stranger));
    bus.detach_gateway(stranger);
    run_until(bus, Instant{0}, Instant{10000});
    EXPECT_EQ(b.heard.size(), 1U);
    EXPECT_EQ(bus.report(Instant{10000}).errors, 0U);
}

TEST_F(BusLoad, ForcingAnUnattachedOrBusOffNodeToBusOffChangesNothing) {
    PlainNode stranger{"stranger"};
    bus.switch_off(stranger, Instant{0});
    EXPECT_THAT(stranger.states, IsEmpty());
    bus.switch_off(a, Instant{0});
    bus.switch_off(a, Instant{1000});
    run_until(bus, Instant{1000}, Instant{100000});
    EXPECT_THAT(a.states, ElementsAre("0 3", "11264 0"));  // 128 × 11 bits of 8 us after the first call
}

TEST_F(BusLoad, EachInterruptedFrameIsAnErrorOfItsReceivers) {
    Instant now{};
    for (int i = 0; i < 96; ++i) {
        EXPECT_THAT(a.states, IsEmpty()) << i;
        Gateway gateway{"gateway", 4, {}};
        bus.attach_gateway(gateway);
        gateway.put(parse_frame("123#", "test"));
        bus.advance(now);
        bus.detach_gateway(gateway);
        now = now + milliseconds(1);
        bus.advance(now);
    }
    ASSERT_EQ(a.states.size(), 1U);  // 96 errors lead to the warning state
    EXPECT_EQ(a.states[0].back(), '1');
    EXPECT_EQ(bus.report(now).errors, 96U);
}

TEST(BusErrors, SenderCountsItsBrokenFramesAsTransmitErrorsOnly) {
    // One frame of twenty is corrupted, so the transmit error counter rises by 8 and falls by 19. If the bus also
    // counted receive errors for a, that counter would never fall, because a receives no frame.
    ArbitratedBus bus{"inproc", 1000000, BusFaultRates{0.05, 0.0, 0.0, 7}};
    PlainNode a{"a"};
    PlainNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    for (int i = 0; i < 4000; ++i) {
        a.send("123#");
    }
    run_until(bus, Instant{0}, Instant{1000000});
    EXPECT_EQ(b.heard.size(), 4000U);
    EXPECT_GT(bus.report(Instant{1000000}).errors, 128U);
    EXPECT_THAT(a.states, IsEmpty());
}

TEST(BusErrors, GatewayIsNeverBusOff) {
    ArbitratedBus bus{"inproc", 1000000, BusFaultRates{0.9, 0.0, 0.0, 7}};
    PlainNode b{"b"};
    bus.attach(b);
    Gateway gateway{"gateway", 50, {}};
    bus.attach_gateway(gateway);
    for (int i = 0; i < 50; ++i) {
        gateway.put(parse_frame("123#", "test"));
    }
    run_until(bus, Instant{0}, Instant{1000000});
    EXPECT_EQ(b.heard.size(), 50U);
    EXPECT_GT(bus.report(Instant{1000000}).errors, 100U);
}

TEST_F(BusLoad, LatencyCountsFromWhenAFrameBecameTheFirstInItsQueue) {
    a.send("703#05");
    a.send("704#05");
    run_until(bus, Instant{0}, Instant{100000});
    // the second frame becomes the first of its queue at the end of the first frame
    EXPECT_EQ(bus.report(Instant{100000}).worst_latency.us, 3 * us_per_bit + time_of("704#05"));
    EXPECT_GE(time_of("704#05"), time_of("703#05"));
}

}  // namespace canproof::host::test
