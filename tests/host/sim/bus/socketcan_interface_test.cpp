// SPDX-License-Identifier: Apache-2.0
// The SocketCAN bus with a fake kernel: controller states, an interface that disappears and returns, and bit rates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "host/base/input_error.hpp"
#include "tests/host/sim/bus/socketcan_case.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

}  // namespace

TEST_F(SocketCan, ErrorFramesGiveTheControllerState) {
    struct Case {
        std::uint32_t error_class;
        std::uint8_t controller;
        std::optional<CanState> state;
        bool overrun;
    };
    // data[1] in linux/can/error.h: 01h/02h receive/transmit overflow, 04h/08h warning, 10h/20h passive, 40h active
    for (const Case& one :
         {Case{CAN_ERR_CRTL, 0x04, CanState::warning, false}, Case{CAN_ERR_CRTL, 0x08, CanState::warning, false},
          Case{CAN_ERR_CRTL, 0x10, CanState::error_passive, false},
          Case{CAN_ERR_CRTL, 0x20, CanState::error_passive, false},
          Case{CAN_ERR_CRTL, 0x30, CanState::error_passive, false},
          Case{CAN_ERR_CRTL, 0x40, CanState::error_active, false}, Case{CAN_ERR_CRTL, 0x01, std::nullopt, true},
          Case{CAN_ERR_CRTL, 0x02, std::nullopt, true}, Case{CAN_ERR_BUSOFF, 0, CanState::bus_off, false},
          Case{CAN_ERR_RESTARTED, 0, CanState::error_active, false}, Case{CAN_ERR_ACK, 0, std::nullopt, false}}) {
        can_frame frame{};
        frame.can_id = CAN_ERR_FLAG | one.error_class;
        frame.data[1] = one.controller;
        const ControllerNews news = read_error_frame(frame);
        EXPECT_EQ(news.state, one.state) << one.error_class << ":" << int{one.controller};
        EXPECT_EQ(news.overrun, one.overrun) << one.error_class << ":" << int{one.controller};
    }
}

TEST_F(SocketCan, NodeIsNotifiedOfErrorPassiveBusOffAndRecovery) {
    start();
    system.arrive_error(first, CAN_ERR_CRTL, 0x10);
    step(10);
    system.arrive_error(first, CAN_ERR_BUSOFF, 0);
    step(10);
    system.arrive_error(first, CAN_ERR_RESTARTED, 0);
    step(10);
    EXPECT_THAT(a.states, SizeIs(3));
    EXPECT_THAT(a.states[0], HasSubstr(" 2"));
    EXPECT_THAT(a.states[1], HasSubstr(" 3"));
    EXPECT_THAT(a.states[2], HasSubstr(" 0"));
    EXPECT_THAT(a.heard, IsEmpty());
    EXPECT_EQ(bus->report(now).errors, 3U);
}

TEST_F(SocketCan, PersistentBusOffIsRestartedOnlyWithPermission) {
    start();
    system.arrive_error(first, CAN_ERR_BUSOFF, 0);
    step(10);
    step(500000);
    EXPECT_EQ(system.restarts, 0);
    ASSERT_THAT(notices, SizeIs(1));
    EXPECT_THAT(notices[0], HasSubstr("ip link set vcan0 type can restart"));

    start(InterfaceControl::granted);
    system.arrive_error(first + 3, CAN_ERR_BUSOFF, 0);
    step(10);
    step(499989);  // the error frame arrived 10 us before it was read
    EXPECT_EQ(system.restarts, 0);
    step(1);
    EXPECT_EQ(system.restarts, 1);
}

TEST_F(SocketCan, ReceiveOverflowIsAnOverrunUntilAFrameArrivesWithoutLoss) {
    start();
    system.arrive_error(first, CAN_ERR_CRTL, 0x01);
    step(10);
    system.arrive(first, "603#40", system.realtime_us);
    step(10);
    system.arrive(first, "603#40", system.realtime_us, 2);  // this socket has lost two frames
    step(10);
    system.arrive(first, "603#40", system.realtime_us, 2);
    step(10);
    EXPECT_THAT(a.overruns, ElementsAre(true, false, true, false));
}

TEST_F(SocketCan, InterfaceDownAndUpIsBusOffAndRecovery) {
    start();
    system.up = false;
    system.fail(first, ENETDOWN);
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0 is down; waiting for it"));
    // no descriptor is watched; the only deadline is the next search for the interface
    EXPECT_THAT(bus->watches(), IsEmpty());
    EXPECT_EQ(bus->next_deadline().us, now.us + 100000);
    step(100000);
    EXPECT_EQ(bus->next_deadline().us, now.us + 100000);
    system.up = true;
    step(100000);
    EXPECT_THAT(notices, SizeIs(2));
    EXPECT_EQ(notices.back(), "vcan0 is up again");
    EXPECT_THAT(a.states, SizeIs(2));
    EXPECT_THAT(b.states, SizeIs(2));
    a.send("703#05");
    step(10);
    EXPECT_THAT(system.sockets[first].sent, ElementsAre("703#05"));
}

TEST_F(SocketCan, FailedSendDetectsThatTheInterfaceIsDown) {
    start();
    a.send("703#05");
    system.up = false;
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0 is down; waiting for it"));
    EXPECT_EQ(system.sockets[first].send_calls, 1);
}

TEST_F(SocketCan, InterfaceDownAndUpBetweenTwoPollsIsNotReportedToTheNode) {
    start();
    system.fail(first, ENETDOWN);  // the error arrives late: the interface is up already
    step(10);
    EXPECT_THAT(a.states, IsEmpty());
    EXPECT_THAT(notices, IsEmpty());
}

TEST_F(SocketCan, RecreatedInterfaceGetsNewSockets) {
    start();
    system.number = 0;
    system.up = false;
    system.fail(monitor, ENODEV);
    step(10);
    EXPECT_THAT(notices, ElementsAre("vcan0 is gone; waiting for it"));
    system.number = 9;
    system.up = true;
    step(100000);
    EXPECT_FALSE(FakeCanSystem::is_open(first));
    ASSERT_THAT(system.sockets, SizeIs(6));
    a.send("703#05");
    step(10);
    EXPECT_THAT(system.sockets[first + 3].sent, ElementsAre("703#05"));
}

TEST_F(SocketCan, BitRateThatLssSelectsIsSetOnTheInterfaceWithPermission) {
    a.rate = 125000;
    start(InterfaceControl::granted);
    a.rate = 250000;
    step(10);
    EXPECT_THAT(system.rates_set, ElementsAre(250000U));
    EXPECT_THAT(notices, ElementsAre("a: LSS sets 250000 bit/s; vcan0 has this bit rate now"));
    step(10);
    EXPECT_THAT(system.rates_set, SizeIs(1));
}

TEST_F(SocketCan, BitRateThatLssSelectsButCannotBeSetIsReportedToTheUser) {
    a.rate = 125000;
    start();
    a.rate = 250000;
    step(10);
    EXPECT_THAT(system.rates_set, IsEmpty());
    ASSERT_THAT(notices, SizeIs(1));
    EXPECT_THAT(notices[0], HasSubstr("without --control-interface"));
    EXPECT_THAT(notices[0], HasSubstr("ip link set vcan0 type can bitrate 250000"));

    system.rate_refusal = "vcan0 has no bit rate that can be set";
    start(InterfaceControl::granted);
    a.rate = 500000;
    step(10);
    EXPECT_THAT(notices.back(), HasSubstr("vcan0 has no bit rate that can be set"));
    EXPECT_THAT(notices.back(), HasSubstr("bitrate 500000"));
}

TEST_F(SocketCan, MissingInterfaceOrKernelSupportIsReportedWithTheRemedy) {
    const auto message = [this](int error) {
        system.open_error = error;
        try {
            SocketCanBus{"vcan7", system, InterfaceControl::none, Instant{}};
        } catch (const InputError& refused) {
            return std::string{refused.what()};
        }
        return std::string{};
    };
    EXPECT_THAT(message(ENODEV), HasSubstr("ip link add dev vcan7 type vcan"));
    EXPECT_THAT(message(EAFNOSUPPORT), HasSubstr("no SocketCAN"));
}

}  // namespace canproof::host::test
