// SPDX-License-Identifier: Apache-2.0
// The SocketCAN bus with a fake kernel: the order of events, and the independence of the nodes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "host/sim/bus/can_bits.hpp"
#include "tests/host/sim/bus/socketcan_case.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int third = 103;

/// Records overruns and frames in one list. For each frame, it accepts one further identifier and sends an answer.
class AskingNode : public PlainNode {
  public:
    using PlainNode::PlainNode;
    void receive(const Frame& frame, Instant) override {
        told.push_back(format_frame(frame));
        accepted.push_back({frame.id + 1U, 0x7FF, false});
        send("583#60");
    }
    void set_overrun(bool lost, Instant) override { told.emplace_back(lost ? "overrun" : "no overrun"); }

    std::vector<std::string> told;
};

}  // namespace

TEST_F(SocketCan, OverrunIsReportedBeforeTheFrame_AndNewFiltersAreSetBeforeTheAnswer) {
    start();
    AskingNode asking{"asking"};
    bus->attach(asking);
    system.arrive(third, "603#40", system.realtime_us, 1);
    step(10);
    EXPECT_THAT(asking.told, ElementsAre("overrun", "603#40"));
    EXPECT_THAT(system.sockets[third].filters_when_sent,
                ElementsAre(3U));  // two initial filters that accept all frames, and the new filter
}

TEST_F(SocketCan, UserFrameIsLoggedAfterEarlierFrames) {
    start();
    bus->put(parse_frame("000#0100", "test"), now);
    system.arrive(monitor, "080#", system.realtime_us + 100);
    system.arrive(monitor, "081#", system.realtime_us + 200);
    step(300);
    EXPECT_THAT(log, ElementsAre("1000100 - 080#", "1000200 - 081#", "1000300 - 000#0100"));
}

TEST_F(SocketCan, UserFrameIsNotMatchedAsAnEchoOfANode) {
    start();
    bus->put(parse_frame("703#05", "test"), now);
    step(10);
    a.send("703#05");
    step(10);
    system.arrive(monitor, "703#05", system.realtime_us);
    step(10);
    EXPECT_THAT(log, ElementsAre("1000010 - 703#05", "1000020 a 703#05"));
}

TEST_F(SocketCan, NewlyReadFramesAreMergedInTimeOrderWithFramesReadBefore) {
    start_with_three_frames();
    system.arrive(first, "603#01", 5000400);
    system.arrive(second, "604#02", 5000200);
    bus->poll(now);
    bus->advance(Instant{1000250});
    EXPECT_THAT(log, ElementsAre("1000100 - 080#"));
    EXPECT_THAT(b.heard, ElementsAre("1000200 604#02"));
    EXPECT_THAT(a.heard, IsEmpty());
}

TEST_F(SocketCan, ReadingContinuesWhileAllReadFramesHaveFutureTimestamps) {
    start();
    constexpr std::size_t count = SocketCanBus::most_arrived + 10;
    for (std::size_t i = 0; i < count; ++i) {
        system.arrive(monitor, "080#", system.realtime_us + 1000000);
    }
    for (int turn = 0; turn < 20; ++turn) {
        bus->poll(now);
    }
    EXPECT_THAT(system.sockets[monitor].arriving, IsEmpty());
}

TEST_F(SocketCan, NothingIsReadWhileTheInterfaceIsDown) {
    start();
    system.up = false;
    system.fail(monitor, ENETDOWN);
    system.arrive(first, "603#40", system.realtime_us);
    step(10);
    step(10);
    EXPECT_THAT(a.heard, IsEmpty());
    system.up = true;
    step(100000);
    step(10);
    EXPECT_THAT(a.heard, SizeIs(1));
}

TEST_F(SocketCan, FrameTimeIsCorrectedByAClockOffsetOf20Milliseconds) {
    system.realtime_us = 1020000;  // the real time is 20 ms ahead of the run time
    start();
    system.arrive(first, "603#40", 1020010);
    step(100);
    EXPECT_THAT(a.heard, ElementsAre("1000010 603#40"));
}

TEST_F(SocketCan, FrameStampedAtTheStartOfTheRunIsDueAtTime0) {
    start();
    system.arrive(first, "603#40", 4000000);
    bus->poll(now);
    EXPECT_EQ(bus->next_deadline(), Instant{0});
}

TEST_F(SocketCan, NoDeadlineRemainsWhenANodeDropsItsWaitingFrame) {
    start();
    a.send("703#05");
    system.sockets[first].send_answers = {ENOBUFS};
    step(10);
    a.waiting.clear();
    step(1000);
    EXPECT_EQ(bus->next_deadline(), never);
    EXPECT_EQ(system.sockets[first].send_calls, 1);
}

TEST_F(SocketCan, WhileTheInterfaceIsDownTheNextDeadlineIsTheSearchForIt) {
    start();
    a.send("703#05");
    b.send("704#05");
    system.sockets[second].send_answers = {ENOBUFS};
    step(10);
    a.send("703#05");
    system.up = false;
    step(10);
    EXPECT_EQ(bus->next_deadline().us, now.us + 100000);
}

TEST_F(SocketCan, LateErrorAfterAnInterfaceWasRecreatedIsIgnored) {
    start();
    system.number = 9;
    system.fail(first, ENODEV);
    step(10);
    system.number = 0;  // number 0 means that the interface does not exist, whatever its flags are
    step(100000);
    EXPECT_THAT(notices, SizeIs(1));
    system.number = 9;
    step(100000);
    EXPECT_THAT(notices, SizeIs(2));
    system.fail(first + 3, ENETDOWN);  // the error arrives late: the interface is up already
    step(10);
    EXPECT_THAT(notices, SizeIs(2));
    EXPECT_THAT(a.states, SizeIs(2));
}

TEST_F(SocketCan, InitialBitRateOfANodeIsNotReported) {
    a.rate = 125000;
    start(InterfaceControl::granted);
    step(10);
    EXPECT_THAT(notices, IsEmpty());
    EXPECT_THAT(system.rates_set, IsEmpty());
}

TEST_F(SocketCan, LossIsReportedOnlyForTheSocketThatLostFrames) {
    a.rate = 125000;
    start();
    system.arrive(first, "603#40", system.realtime_us);
    step(10);
    EXPECT_THAT(notices, IsEmpty());
    system.arrive(monitor, "603#40", system.realtime_us, 3);
    system.arrive(first, "603#40", system.realtime_us);
    step(10);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("3 frames arrived faster")));
    step(2000000);
    EXPECT_THAT(notices, SizeIs(1));  // no further notice for the other socket
}

TEST_F(SocketCan, SmallBufferOfOneSocketIsReportedWithTheRemedy) {
    // only the sockets from `first` on get the requested buffer; that of the monitor is small
    system.first_roomy = first;
    start();
    system.arrive(first, "603#40", system.realtime_us, 1);
    step(10);
    EXPECT_THAT(notices, ElementsAre(HasSubstr("are lost for a"), HasSubstr("net.core.rmem_max")));
}

TEST_F(SocketCan, LoadAtALowBitRateIsExact) {
    system.rate = 20;  // one bit lasts 50 ms
    start();
    system.arrive(monitor, "703#05", system.realtime_us);
    step(10);
    EXPECT_NEAR(bus->report(Instant{1000000}).load, 1.0, 1.0e-9);  // the frame has taken more than three seconds
    EXPECT_NEAR(bus->report(Instant{1250000}).load, 0.75, 1.0e-9);
}

TEST_F(SocketCan, UserFrameThatTheKernelRefusesIsNeitherLoggedNorCounted) {
    start();
    system.sockets[monitor].send_answers = {EINVAL};
    bus->put(parse_frame("000#0100", "test"), now);
    bus->put(parse_frame("000#0200", "test"), now);
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0 refused the frame 000#0100 (Invalid argument)"));
    EXPECT_THAT(log, ElementsAre("1000010 - 000#0200"));
    EXPECT_EQ(bus->report(now).frames, 1U);
}

TEST_F(SocketCan, LossBeforeAnErrorFrameIsAnOverrunUntilTheNextFrame) {
    start();
    system.arrive_error(first, CAN_ERR_CRTL, 0x08);
    system.sockets[first].arriving.back().got.dropped = 2;
    step(10);
    EXPECT_THAT(a.overruns, ElementsAre(true));
    system.arrive(first, "603#40", system.realtime_us, 2);
    step(10);
    EXPECT_THAT(a.overruns, ElementsAre(true, false));
}

TEST_F(SocketCan, SocketsAreWatchedForReadingOnly) {
    start();
    a.send("703#05");
    system.sockets[first].send_answers = {ENOBUFS};
    step(10);
    int next = monitor;
    for (const Watch& watch : bus->watches()) {
        EXPECT_EQ(watch.descriptor, next++);
        EXPECT_TRUE(watch.readable);
        EXPECT_FALSE(watch.writable);  // a socket is always writable, so the loop would never wait
    }
    EXPECT_EQ(next, monitor + 3);
}

TEST_F(SocketCan, ManyFramesOfOneTimeKeepTheirOrderOfArrival) {
    start();
    std::vector<std::string> expected;
    for (unsigned i = 0; i < 100; ++i) {
        const std::string text = fmt::format("080#{:02X}", i);
        system.arrive(monitor, text, system.realtime_us + 500);
        expected.push_back("1000500 - " + text);
    }
    bus->poll(now);
    system.arrive(monitor, "080#64", system.realtime_us + 500);
    expected.emplace_back("1000500 - 080#64");
    step(1000);
    EXPECT_EQ(log, expected);
}

TEST_F(SocketCan, LossesAreCountedWhenTheCounterOfTheKernelOverflows) {
    start();
    system.arrive(first, "603#40", system.realtime_us, 4294967290U);
    step(10);
    system.arrive(first, "603#40", system.realtime_us, 4);  // ten frames later: the counter has 32 bits
    EXPECT_EQ(bus->report(now).missed, 4294967300U);
    step(10);
    EXPECT_EQ(bus->report(now).missed, 4294967300U);
    EXPECT_THAT(a.overruns, ElementsAre(true));
}

}  // namespace canproof::host::test
