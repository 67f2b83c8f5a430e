// SPDX-License-Identifier: Apache-2.0
// The SocketCAN bus with a fake kernel: load, results of sending and reading, and restarts of a controller.
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

}  // namespace

TEST_F(SocketCan, LoadCoversTheLastSecondAtTheBitRateOfTheInterface) {
    system.rate = 500000;  // one bit lasts 2 us
    start();
    EXPECT_EQ(bus->report(now).bit_rate, 500000U);
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);
    system.arrive(monitor, "703#05", system.realtime_us + 10);
    step(10);
    const double one = 2.0 * (frame_bits(parse_frame("703#05", "test")) + 3.0) / 1.0e6;
    EXPECT_NEAR(bus->report(now).load, one, 1.0e-9);
    system.arrive(monitor, "703#05", system.realtime_us + 600000);
    step(600000);
    EXPECT_NEAR(bus->report(now).load, 2.0 * one, 1.0e-9);
    EXPECT_NEAR(bus->report(Instant{2000009}).load, one + 1.0e-6, 1.0e-9);  // the last microsecond of the first frame
    EXPECT_NEAR(bus->report(Instant{2000010}).load, one, 1.0e-9);           // the first frame ended one second ago
    system.arrive(monitor, "703#05", system.realtime_us + 500000);
    step(500000);
    EXPECT_NEAR(bus->report(now).load, 2.0 * one, 1.0e-9);
    EXPECT_EQ(bus->report(now).frames, 3U);
}

TEST_F(SocketCan, LoadBeginsWithTheRun) {
    system.rate = 500000;
    bus = std::make_unique<SocketCanBus>("vcan0", system, InterfaceControl::none, Instant{});
    system.arrive(monitor, "703#05", system.realtime_us + 100);  // the frame began before the run: 58 bits take 116 us
    now = Instant{};
    step(1000);
    EXPECT_NEAR(bus->report(now).load, 0.1, 1.0e-9);  // 100 us of 1000 us
}

TEST_F(SocketCan, InterfaceWithoutABitRateHasNoLoad) {
    start();
    system.arrive(monitor, "703#05", system.realtime_us);
    step(10);
    EXPECT_DOUBLE_EQ(bus->report(now).load, 0.0);
    EXPECT_EQ(bus->report(now).frames, 1U);
}

TEST_F(SocketCan, RefusedFrameIsReportedAndTheNextFrameIsSent) {
    start();
    a.send("703#05");
    a.send("704#05");
    system.sockets[first].send_answers = {EINVAL};
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0 refused the frame 703#05 (Invalid argument)"));
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("704#05"));
    system.arrive(monitor, "703#05", system.realtime_us);  // the same frame from another program
    system.arrive(monitor, "704#05", system.realtime_us);
    step(10);
    EXPECT_THAT(log, ElementsAre("1000010 - 703#05", "1000010 a 704#05"));
    EXPECT_EQ(bus->next_deadline(), never);
}

TEST_F(SocketCan, SendRefusedWithEagainIsRetried) {
    start();
    a.send("703#05");
    system.sockets[first].send_answers = {EAGAIN};
    step(10);
    EXPECT_EQ(bus->next_deadline().us, now.us + 1000);
    step(1000);
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("703#05"));
    EXPECT_THAT(notices, IsEmpty());
}

TEST_F(SocketCan, SendDuringAMomentaryInterfaceLossIsRetried) {
    for (const int error : {ENETDOWN, ENODEV, ENXIO, ENOENT}) {
        start();
        const int socket_of_a = system.next_descriptor - 2;
        a.send("703#05");
        system.sockets[socket_of_a].send_answers = {error};  // the send fails although the interface is up
        step(10);
        EXPECT_THAT(a.states, IsEmpty()) << error;
        EXPECT_EQ(bus->next_deadline().us, now.us + 16000) << error;
        step(16000);
        EXPECT_THAT(system.sockets[socket_of_a].sent, ElementsAre("703#05")) << error;
        EXPECT_EQ(bus->next_deadline(), never) << error;
    }
}

TEST_F(SocketCan, RefusedFrameIsRetriedAfterItsPauseAndNotWhenAFrameArrives) {
    start();
    a.send("703#05");
    system.sockets[first].send_answers = {ENOBUFS, ENOBUFS};
    step(10);
    system.arrive(first, "603#40", system.realtime_us + 100);
    step(100);
    EXPECT_EQ(system.sockets[first].send_calls, 1);
    EXPECT_THAT(a.heard, SizeIs(1));
    step(900);
    EXPECT_EQ(system.sockets[first].send_calls, 2);
}

TEST_F(SocketCan, UpTo256FramesFromTheUserWait_AndAreCountedWhenSent) {
    start();
    system.sockets[monitor].send_answers = {ENOBUFS};
    int taken = 0;
    while (taken < 1000 && bus->put(parse_frame("000#0100", "test"), now)) {
        ++taken;
    }
    EXPECT_EQ(taken, 256);
    step(10);
    EXPECT_THAT(log, IsEmpty());
    EXPECT_EQ(bus->report(now).frames, 0U);
    step(1000);
    EXPECT_EQ(bus->report(now).frames, 256U);
    EXPECT_TRUE(bus->put(parse_frame("000#0100", "test"), now));
}

TEST_F(SocketCan, FrameWithoutTimestampOrFromBeforeTheRunIsDueNow) {
    start();
    step(10);
    CanReception got;
    got.frame = to_kernel(parse_frame("603#40", "test"));
    system.sockets[first].arriving.push_back({got});  // a frame without a timestamp
    step(10);
    EXPECT_THAT(a.heard, ElementsAre("1000020 603#40"));
    system.arrive(first, "603#41", 3999999);  // the timestamp is before time 0 of the run
    step(10);
    EXPECT_EQ(a.heard.back(), "1000030 603#41");
    system.arrive(first, "603#42", 5000001);  // the timestamp is before that of a frame delivered already
    now.us += 10;
    system.realtime_us += 10;
    bus->poll(now);
    EXPECT_EQ(bus->next_deadline().us, 1000030U);
    bus->advance(now);
    EXPECT_EQ(a.heard.back(), "1000030 603#42");
}

TEST_F(SocketCan, ClockDriftUpTo50MsKeepsTheClockOffset) {
    start();
    step(10);
    now.us += 100000;
    system.realtime_us += 150000;  // 50 ms more than the run clock: the largest tolerated difference
    system.arrive(first, "603#40", system.realtime_us - 100);
    bus->poll(now);
    EXPECT_EQ(bus->next_deadline().us, now.us + 49900);  // the frame keeps its time with the original offset of 4 s
    now.us += 100000;
    bus->advance(now);
    now.us += 1000;
    system.realtime_us += 101001;  // 1 us more than the tolerated difference
    system.arrive(first, "603#41", system.realtime_us - 100);
    bus->poll(now);
    EXPECT_EQ(bus->next_deadline().us, now.us - 100);  // the frame gets its time with the new offset
}

TEST_F(SocketCan, ErrorFrameReceivedByManyNodesCountsOnce) {
    start();
    system.arrive_error(first, CAN_ERR_PROT, 0);
    system.arrive_error(second, CAN_ERR_PROT, 0);
    step(10);
    EXPECT_EQ(bus->report(now).errors, 1U);
    EXPECT_THAT(a.states, IsEmpty());
    EXPECT_THAT(a.overruns, IsEmpty());
    system.arrive_error(monitor, CAN_ERR_BUSOFF, 0);  // the monitor asks for no error frames
    step(10);
    EXPECT_EQ(bus->report(now).errors, 1U);
    EXPECT_THAT(log, IsEmpty());
}

TEST_F(SocketCan, RepeatedControllerStateIsReportedOnce) {
    start();
    for (int i = 0; i < 3; ++i) {
        system.arrive_error(first, CAN_ERR_CRTL, 0x08);
        system.arrive_error(first, CAN_ERR_CRTL, 0x01);
    }
    step(10);
    EXPECT_THAT(a.states, ElementsAre("1000000 1"));
    EXPECT_THAT(a.overruns, ElementsAre(true));
    EXPECT_THAT(b.states, IsEmpty());
}

TEST_F(SocketCan, ControllerThatRecoversByItselfIsNotRestarted) {
    start(InterfaceControl::granted);
    system.arrive_error(first, CAN_ERR_BUSOFF, 0);
    step(10);
    EXPECT_EQ(bus->next_deadline().us, 1500000U);  // half a second after the error frame
    system.arrive_error(first, CAN_ERR_RESTARTED, 0);
    step(10);
    EXPECT_EQ(bus->next_deadline(), never);
    step(600000);
    EXPECT_EQ(system.restarts, 0);
}

TEST_F(SocketCan, FailedRestartIsRetried) {
    start(InterfaceControl::granted);
    system.restart_answer = false;
    system.arrive_error(first, CAN_ERR_BUSOFF, 0);
    step(10);
    step(500000);
    EXPECT_EQ(system.restarts, 1);
    EXPECT_EQ(bus->next_deadline().us, now.us + 500000);
    system.restart_answer = true;
    step(500000);
    EXPECT_EQ(system.restarts, 2);
    EXPECT_EQ(bus->next_deadline(), never);
    step(500000);
    EXPECT_EQ(system.restarts, 2);
}

TEST_F(SocketCan, RestartRefusedByTheKernelIsReportedOnceForEachBusOff) {
    start(InterfaceControl::granted);
    system.restart_answer = false;
    for (std::size_t bus_off = 1; bus_off <= 2; ++bus_off) {
        system.arrive_error(first, CAN_ERR_BUSOFF, 0);
        step(10);
        const int earlier = system.restarts;
        for (int attempts = 1; attempts <= 3; ++attempts) {
            step(500000);
            EXPECT_EQ(system.restarts, earlier + attempts);
            EXPECT_THAT(notices, SizeIs(bus_off));
        }
        EXPECT_THAT(notices.back(), HasSubstr("vcan0 is bus-off, and the kernel refuses the restart"));
        system.arrive_error(first, CAN_ERR_RESTARTED, 0);
        step(10);
    }
}

TEST_F(SocketCan, RestartWithoutPermissionIsReportedOnce) {
    start();
    system.arrive_error(first, CAN_ERR_BUSOFF, 0);
    step(10);
    step(500000);
    EXPECT_EQ(bus->next_deadline(), never);
    step(500000);
    EXPECT_THAT(notices, SizeIs(1));
}

TEST_F(SocketCan, InterfaceDownAtTheStartIsBusOffForItsNodes) {
    system.up = false;
    start();
    EXPECT_THAT(a.states, ElementsAre("0 3"));
    EXPECT_THAT(bus->watches(), IsEmpty());
    EXPECT_EQ(bus->next_deadline().us, 1100000U);
    a.send("703#05");
    step(10);
    EXPECT_EQ(system.sockets[first].send_calls, 0);
    system.up = true;
    step(100000);
    EXPECT_THAT(a.states, SizeIs(2));
    EXPECT_THAT(notices, ElementsAre("vcan0 is up again"));
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("703#05"));
}

TEST_F(SocketCan, InterfaceOnWhichSocketsCannotBeOpenedIsTriedAgainLater) {
    start();
    system.number = 0;
    system.up = false;
    system.fail(first, ENODEV);
    step(10);
    system.number = 9;
    step(100000);  // the interface exists but is down
    EXPECT_THAT(notices, SizeIs(1));
    system.up = true;
    system.open_error = ENODEV;
    step(100000);  // the interface disappears between two calls
    a.accepted = {{0x604, 0x7FF, false}};
    step(100000);
    EXPECT_THAT(notices, SizeIs(1));
    EXPECT_THAT(system.sockets, SizeIs(3));  // no socket was opened on a missing interface
    EXPECT_FALSE(FakeCanSystem::is_open(first));
    EXPECT_THAT(bus->watches(), IsEmpty());
    EXPECT_EQ(bus->next_deadline().us, now.us + 100000);
    system.open_error = 0;
    system.rate = 250000;
    step(100000);
    EXPECT_THAT(notices, ElementsAre("vcan0 is gone; waiting for it", "vcan0 is up again"));
    EXPECT_EQ(bus->report(now).bit_rate, 250000U);
    EXPECT_THAT(bus->watches(), SizeIs(3));
    EXPECT_EQ(bus->next_deadline(), never);
}

TEST_F(SocketCan, NewSocketCountsItsLossesFromZero) {
    a.rate = 125000;
    start();
    system.arrive(first, "603#40", system.realtime_us, 5);
    step(10);
    EXPECT_EQ(bus->report(now).missed, 5U);
    system.number = 9;
    system.up = false;
    system.fail(first, ENETDOWN);
    step(10);
    system.up = true;
    system.open_error = ENODEV;
    step(100000);
    EXPECT_EQ(bus->report(now).missed, 5U);  // the count remains while the node has no socket
    system.open_error = 0;
    step(100000);
    const int again = first + 3;
    system.arrive(again, "603#40", system.realtime_us, 5);
    step(10);
    EXPECT_EQ(bus->report(now).missed, 10U);
    EXPECT_THAT(a.overruns, ElementsAre(true));  // no frame came between the two losses, so they are one overrun
}

TEST_F(SocketCan, RecreatedInterfaceIsDistinguishedFromTheOldInterface) {
    start();
    system.number = 9;  // another interface number: the interface was removed and created again; it is up whenever the
                        // bus asks for its state
    system.fail(first, ENODEV);
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0 is down; waiting for it"));
    EXPECT_THAT(a.states, SizeIs(1));
    step(100000);
    EXPECT_THAT(a.states, SizeIs(2));
    EXPECT_FALSE(FakeCanSystem::is_open(first));
}

TEST_F(SocketCan, BusReportContainsTheBitRateThatWasSet) {
    a.rate = 125000;
    system.rate = 125000;
    start(InterfaceControl::granted);
    a.rate = 250000;
    step(10);
    EXPECT_EQ(bus->report(now).bit_rate, 250000U);
    a.rate = 0;  // the node accepts the bit rate of the bus
    step(10);
    EXPECT_THAT(system.rates_set, ElementsAre(250000U));
    a.rate = 250000;
    step(10);
    EXPECT_THAT(system.rates_set, ElementsAre(250000U, 250000U));
    system.rate_refusal = "busy";
    a.rate = 500000;
    step(10);
    EXPECT_EQ(bus->report(now).bit_rate, 250000U);
}

TEST_F(SocketCan, UnchangedFiltersAreNotSetAgain) {
    a.accepted = {{0x603, 0x7FF, false}};
    start();
    system.sockets[first].filters.clear();
    step(10);
    EXPECT_THAT(system.sockets[first].filters, IsEmpty());
    a.accepted = {{0x604, 0x7FF, false}};
    step(10);
    ASSERT_THAT(system.sockets[first].filters, SizeIs(1));
    EXPECT_EQ(system.sockets[first].filters[0].can_id, 0x604U);
    system.sockets[first].filters.clear();
    step(10);
    EXPECT_THAT(system.sockets[first].filters, IsEmpty());
}

TEST_F(SocketCan, MissingRightsAreReportedWithTheRemedy) {
    system.open_error = EPERM;
    try {
        SocketCanBus{"vcan7", system, InterfaceControl::none, Instant{}};
        FAIL() << "opened";
    } catch (const std::exception& refused) {
        EXPECT_THAT(refused.what(),
                    HasSubstr("vcan7 cannot be opened (Operation not permitted); check that it is a CAN interface and "
                              "that you have the permission to use it"));
    }
}

TEST_F(SocketCan, SocketsAreClosedAtTheEnd) {
    start();
    bus.reset();
    for (const auto& [descriptor, socket] : system.sockets) {
        EXPECT_FALSE(FakeCanSystem::is_open(descriptor)) << descriptor;
    }
}

}  // namespace canproof::host::test
