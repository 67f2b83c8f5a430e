// SPDX-License-Identifier: Apache-2.0
// Rules of the SocketCAN bus with a fake kernel: filters, order and time of frames, ENOBUFS and losses.
#include "host/sim/bus/socketcan_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/sim/bus/socketcan_case.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

}  // namespace

TEST_F(SocketCan, EachNodeSocketHasItsFiltersAndTheMonitorReceivesEverything) {
    a.accepted = {{0x000, 0x7FF, false}, {0x603, 0x7FF, false}};
    start();
    ASSERT_THAT(system.sockets, SizeIs(3));
    EXPECT_FALSE(system.sockets[monitor].error_frames);
    EXPECT_TRUE(system.sockets[first].error_frames);
    const auto& filters = system.sockets[first].filters;
    ASSERT_THAT(filters, SizeIs(2));
    EXPECT_EQ(filters[1].can_id, 0x603U);
    EXPECT_EQ(filters[1].can_mask, 0x7FFU | CAN_EFF_FLAG);
    EXPECT_THAT(system.sockets[monitor].filters, IsEmpty());
    EXPECT_THAT(bus->watches(), SizeIs(3));
}

TEST_F(SocketCan, NewFiltersOfANodeAreSetAtTheNextStep) {
    a.accepted = {{0x603, 0x7FF, false}};
    start();
    a.accepted.push_back({0x203, 0x7FF, false});
    system.arrive(first, "603#2300140103020000", 5000100);
    step(200);
    EXPECT_THAT(system.sockets[first].filters, SizeIs(2));
}

TEST_F(SocketCan, MoreThan512FiltersBecomeOneThatAcceptsAllFrames) {
    std::vector<AcceptanceFilter> many(513, AcceptanceFilter{0x123, 0x7FF, false});
    const auto filters = kernel_filters(many);
    ASSERT_THAT(filters, SizeIs(1));
    EXPECT_EQ(filters[0].can_mask, 0U);
    many.pop_back();
    EXPECT_THAT(kernel_filters(many), SizeIs(512));
}

TEST_F(SocketCan, FramesKeepTheirKernelTimestamp) {
    start();
    system.arrive(first, "603#40", 5000300);
    system.arrive(second, "604#40", 5000200);
    system.arrive(monitor, "604#40", 5000200);
    system.arrive(monitor, "603#40", 5000300);
    step(1000);
    EXPECT_THAT(a.heard, ElementsAre("1000300 603#40"));
    EXPECT_THAT(b.heard, ElementsAre("1000200 604#40"));
    EXPECT_THAT(log, ElementsAre("1000200 - 604#40", "1000300 - 603#40"));
}

TEST_F(SocketCan, FrameWithAFutureTimestampWaitsForItsTime) {
    start();
    system.arrive(first, "603#40", 5000900);
    step(800);
    EXPECT_THAT(a.heard, IsEmpty());
    EXPECT_EQ(bus->next_deadline().us, 1000900U);
    step(100);
    EXPECT_THAT(a.heard, ElementsAre("1000900 603#40"));
}

TEST_F(SocketCan, ClockChangeDuringTheRunDoesNotMoveFrames) {
    start();
    system.realtime_us += 3600U * 1000000U;  // the clock is set one hour ahead
    system.arrive(first, "603#40", system.realtime_us + 100);
    step(200);
    EXPECT_THAT(a.heard, ElementsAre("1000100 603#40"));
}

TEST_F(SocketCan, EchoedFramesAreAttributedToTheirSender) {
    start();
    a.send("703#05");
    step(10);
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("703#05"));
    system.arrive(monitor, "703#05", 5000060);
    system.arrive(monitor, "703#05", 5000070);  // the same frame a second time, from another program
    step(100);
    EXPECT_THAT(log, ElementsAre("1000060 a 703#05", "1000070 - 703#05"));
    EXPECT_EQ(bus->report(now).worst_latency.us, 50U);
    EXPECT_EQ(bus->report(now).frames, 2U);
}

TEST_F(SocketCan, FramesAreRetriedWithGrowingPausesWhileTheDeviceQueueIsFull) {
    start();
    a.send("703#05");
    a.send("183#01");
    system.sockets[first].send_answers = {ENOBUFS, ENOBUFS, ENOBUFS, 0};
    step(10);
    EXPECT_EQ(system.sockets[first].send_calls, 1);
    EXPECT_EQ(bus->next_deadline().us, now.us + 1000);  // the first pause lasts 1 ms
    step(500);                                          // a call before the pause ends does not send
    EXPECT_EQ(system.sockets[first].send_calls, 1);
    step(500);
    EXPECT_EQ(system.sockets[first].send_calls, 2);
    EXPECT_EQ(bus->next_deadline().us, now.us + 2000);
    step(2000);
    EXPECT_EQ(bus->next_deadline().us, now.us + 4000);
    EXPECT_THAT(system.sockets[first].sent, IsEmpty());
    step(4000);
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("703#05", "183#01"));
    EXPECT_EQ(bus->next_deadline(), never);
}

TEST_F(SocketCan, RetryPauseGrowsTo16Ms_AndStartsAgainAfterSuccess) {
    start();
    a.send("703#05");
    a.send("704#05");
    system.sockets[first].send_answers = {ENOBUFS, ENOBUFS, ENOBUFS, ENOBUFS, ENOBUFS, ENOBUFS, ENOBUFS, 0, ENOBUFS};
    for (const std::uint64_t pause : {1000U, 2000U, 4000U, 8000U, 16000U, 16000U, 16000U, 1000U}) {
        step(pause == 1000U && system.sockets[first].send_calls == 0 ? 1 : elapsed(now, bus->next_deadline()).us);
        EXPECT_EQ(elapsed(now, bus->next_deadline()).us, pause);
    }
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("703#05"));
}

TEST_F(SocketCan, FullQueueOfOneNodeDoesNotDelayAnother) {
    start();
    a.send("703#05");
    b.send("704#05");
    system.sockets[first].send_answers = {ENOBUFS};
    step(10);
    EXPECT_THAT(system.sockets[second].sent, ElementsAre("704#05"));
}

TEST_F(SocketCan, FramesLostForTheLogAreReported) {
    start();
    system.arrive(monitor, "603#40", system.realtime_us);
    step(10);
    EXPECT_THAT(notices, IsEmpty());
    system.arrive(monitor, "603#40", system.realtime_us, 3);
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0: 3 frames arrived faster than they were read and are lost for the log"));
    EXPECT_EQ(bus->report(now).lost, 3U);
    EXPECT_EQ(bus->report(now).missed, 0U);
}

TEST_F(SocketCan, LossesOfANodeAreCountedAndReportedOncePerSecond) {
    system.roomy = false;
    start();
    system.arrive(first, "603#40", system.realtime_us, 2);
    step(10);
    EXPECT_THAT(notices,
                ElementsAre("vcan0: 2 frames arrived faster than they were read and are lost for a",
                            "`sysctl -w net.core.rmem_max=33554432` or CAP_NET_ADMIN permits larger receive buffers"));
    system.arrive(first, "603#40", system.realtime_us, 7);
    step(999999);
    EXPECT_THAT(notices, SizeIs(2));
    step(1);
    ASSERT_THAT(notices, SizeIs(4));
    EXPECT_EQ(notices[2], "vcan0: 7 frames arrived faster than they were read and are lost for a");
    system.sockets[first].dropped = 9;  // no frame has arrived since that could report the count
    EXPECT_EQ(bus->report(now).missed, 9U);
    EXPECT_EQ(bus->report(now).lost, 0U);
}

TEST_F(SocketCan, RunTimeDoesNotAdvanceBeyondFramesThatAreStillUnread) {
    start();
    for (std::uint64_t i = 0; i < 5000; ++i) {
        system.arrive(monitor, "603#40", 5000001 + i);
    }
    system.realtime_us += 10000;
    EXPECT_EQ(bus->poll(Instant{1010000}).us, 1004096U);  // one turn reads 4096 frames, the first of them at 1000001
    bus->advance(Instant{1004096});
    EXPECT_THAT(log, SizeIs(4096));
    EXPECT_EQ(bus->poll(Instant{1010000}).us, 1010000U);
    bus->advance(Instant{1010000});
    ASSERT_THAT(log, SizeIs(5000));
    EXPECT_EQ(log.back(), "1005000 - 603#40");
}

TEST_F(SocketCan, AnswerIsSentBeforeTheNextFrameOfTheSameTime) {
    class Answering : public PlainNode {
      public:
        using PlainNode::PlainNode;
        void receive(const Frame&, Instant) override {
            send("583#60");
            most = std::max(most, waiting.size());
        }
        std::size_t most{0};
    };
    start();
    Answering answering{"answering"};
    bus->attach(answering);
    constexpr int third = 103;
    for (int i = 0; i < 40; ++i) {
        system.arrive(third, "603#40", 5000001);
    }
    step(10);
    EXPECT_THAT(system.sockets[third].sent, SizeIs(40));
    EXPECT_EQ(answering.most, 1U);
}

TEST_F(SocketCan, UserFramesAreSentByTheMonitorSocket) {
    start();
    ASSERT_TRUE(bus->put(parse_frame("000#0100", "test"), now));
    step(10);
    EXPECT_THAT(system.sockets[monitor].sent, ElementsAre("000#0100"));
    EXPECT_THAT(log, ElementsAre("1000010 - 000#0100"));
}

TEST_F(SocketCan, FramesKeepTheirFormatThroughTheKernelStructure) {
    for (const char* text : {"703#05", "000#", "7FF#R", "603#R8", "1FFFFFFF#0102030405060708", "00000001#R2"}) {
        EXPECT_EQ(format_frame(from_kernel(to_kernel(parse_frame(text, "test")))), text);
    }
    EXPECT_EQ(to_kernel(parse_frame("1FFFFFFF#", "test")).can_id, 0x1FFFFFFFU | CAN_EFF_FLAG);
    EXPECT_EQ(to_kernel(parse_frame("703#R", "test")).can_id, 0x703U | CAN_RTR_FLAG);
}

TEST_F(SocketCan, LateRunLeavesFramesInTheKernelAndLosesNone) {
    start();
    constexpr std::size_t count = SocketCanBus::most_arrived + 3 * 4096;  // one turn reads 4096 frames
    for (std::size_t i = 0; i < count; ++i) {
        system.arrive(monitor, "080#", 5000000 + i);
    }
    now.us += count;
    system.realtime_us += count;
    for (int turn = 0; turn < 100; ++turn) {
        bus->poll(now);  // no time to act between the turns
    }
    EXPECT_EQ(system.sockets[monitor].arriving.size(), 3U * 4096U);
    for (int turn = 0; turn < 5; ++turn) {
        bus->advance(bus->poll(now));
    }
    EXPECT_THAT(log, SizeIs(count));
    EXPECT_THAT(system.sockets[monitor].arriving, IsEmpty());
}

TEST_F(SocketCan, FramesAreHandledByTimestampNotByReadOrder) {
    start_with_three_frames();
    system.arrive(first, "603#00", 5000200);
    system.arrive(first, "603#01", 5000400);
    bus->poll(now);
    bus->advance(Instant{1000250});
    EXPECT_THAT(log, ElementsAre("1000100 - 080#"));
    EXPECT_THAT(a.heard, ElementsAre("1000200 603#00"));
    bus->advance(now);
    EXPECT_THAT(log, SizeIs(3));
    EXPECT_THAT(a.heard, SizeIs(2));
}

}  // namespace canproof::host::test
