// SPDX-License-Identifier: Apache-2.0
// The nodes of the in-process bus that receive a frame, and how a frame affects the nodes whose filters refuse it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

}  // namespace

TEST(Delivery, NodeReceivesTheFramesThatItsFiltersAccept) {
    ArbitratedBus bus{"inproc", 125000, BusFaultRates{}};
    PlainNode sender{"sender"};
    PlainNode reader{"reader"};
    PlainNode deaf{"deaf"};
    reader.accepted = {{0x205, 0x7FF, false}};
    deaf.accepted = {};
    for (PlainNode* const node : {&sender, &reader, &deaf}) {
        bus.attach(*node);
    }
    sender.send("205#01");
    sender.send("206#02");
    run_until(bus, Instant{0}, Instant{10000});
    EXPECT_THAT(reader.heard, SizeIs(1));
    EXPECT_THAT(deaf.heard, IsEmpty());
    EXPECT_EQ(bus.report(Instant{10000}).frames, 2U);
}

TEST(Delivery, NodeThatReportsNewFiltersReceivesWhatTheyAccept) {
    ArbitratedBus bus{"inproc", 125000, BusFaultRates{}};
    TellingNode a{"a"};
    TellingNode b{"b"};
    bus.attach(a);
    bus.attach(b);
    b.accept({{0x205, 0x7FF, false}});
    a.send_and_tell("206#01");
    EXPECT_EQ(bus.next_deadline(), Instant{0});  // even before the first call of advance()
    run_until(bus, Instant{0}, Instant{10000});
    b.accept({{0x206, 0x7FF, false}});
    a.send_and_tell("206#02");
    a.send_and_tell("205#03");
    run_until(bus, Instant{10000}, Instant{20000});
    ASSERT_THAT(b.heard, SizeIs(1));
    EXPECT_EQ(b.heard.front().substr(b.heard.front().find(' ')), " 206#02");
}

TEST(Delivery, NextDeadlineOfTheBusIsThatOfTheFirstNodeThatMaySend) {
    ArbitratedBus bus{"inproc", 125000, BusFaultRates{}};
    TellingNode a{"a"};
    TellingNode b{"b"};
    TellingNode c{"c"};
    for (TellingNode* const node : {&a, &b, &c}) {
        bus.attach(*node);
    }
    a.rate = 250000;  // this node is disconnected, although its frame has the lowest identifier
    b.rate = c.rate = 125000;
    c.send_and_tell("123#");
    bus.advance(Instant{0});
    b.send_and_tell("703#05");
    a.send_and_tell("081#");
    const Instant end{std::uint64_t{frame_bits(parse_frame("123#", "test"))} * 8U};
    EXPECT_EQ(bus.next_deadline(), end);
    bus.advance(end);
    EXPECT_EQ(bus.next_deadline(), end + microseconds(24));  // 3 bits of intermission
}

TEST(Delivery, ErrorCountersFollowEachFrameWhetherAcceptedOrNot) {
    // A node reaches the warning state after 96 corrupted frames; each correct frame decreases the counter by one.
    BusFaultRates faults;
    faults.corrupted = 0.7;
    faults.seed = 3;
    ArbitratedBus bus{"inproc", 1000000, faults};
    PlainNode reader{"reader"};
    PlainNode deaf{"deaf"};
    deaf.accepted = {};
    bus.attach(reader);
    bus.attach(deaf);
    Gateway gateway{"gateway", 600, {}};
    bus.attach_gateway(gateway);
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(gateway.put(parse_frame("123#0102030405060708", "test")));
    }
    run_until(bus, Instant{0}, Instant{2000000});
    EXPECT_FALSE(reader.states.empty());
    EXPECT_EQ(deaf.states, reader.states);
}

TEST(Delivery, CorruptedFrameIsNotSentAfterBusOffEvenIfTheNodeNotifiesTheBus) {
    BusFaultRates faults;
    faults.corrupted = 0.9;
    faults.seed = 1;  // with this seed, the first frame is corrupted
    ArbitratedBus bus{"inproc", 125000, faults};
    TellingNode a{"a"};
    bus.attach(a);
    a.send_and_tell("083#");
    bus.advance(Instant{0});
    const Instant end = bus.next_deadline();
    bus.advance(end);
    ASSERT_EQ(bus.report(end).errors, 1U);
    bus.switch_off(a, end);  // node a goes bus-off between the error frame and the repetition
    run_until(bus, end, Instant{1000000});
    EXPECT_THAT(a.states, SizeIs(2));  // bus-off and its end
    EXPECT_EQ(bus.report(Instant{1000000}).frames, 0U);
}

TEST(Delivery, LossOfAFrameIsReportedEvenToANodeThatDoesNotAcceptIt) {
    BusFaultRates faults;
    faults.lost = 0.5;
    faults.seed = 5;
    ArbitratedBus bus{"inproc", 1000000, faults};
    PlainNode deaf{"deaf"};
    deaf.accepted = {};
    bus.attach(deaf);
    Gateway gateway{"gateway", 100, {}};
    bus.attach_gateway(gateway);
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(gateway.put(parse_frame("123#", "test")));
    }
    run_until(bus, Instant{0}, Instant{100000});
    ASSERT_GT(deaf.overruns.size(), 3U);
    for (std::size_t i = 0; i < deaf.overruns.size(); ++i) {
        EXPECT_EQ(deaf.overruns[i], i % 2 == 0) << i;  // one call reports the loss, the next reports its end
    }
}

}  // namespace canproof::host::test
