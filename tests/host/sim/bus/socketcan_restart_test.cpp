// SPDX-License-Identifier: Apache-2.0
// An interface that disappears and returns leaves nothing of its earlier state in the bus.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "host/sim/bus/socketcan_bus.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/fake_can_system.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int monitor = 100;
constexpr int socket_of_a = 101;
constexpr int sockets_of_a_life = 3;

/// Two nodes on vcan0 whose controller the bus may restart.
class SocketCanRestart : public testing::Test {
  protected:
    void SetUp() override {
        bus = std::make_unique<SocketCanBus>("vcan0", system, InterfaceControl::granted, now);
        bus->listen([this](const BusFrame& frame) {
            log.push_back(
                fmt::format("{} {}", frame.sender == nullptr ? "-" : frame.sender->name(), format_frame(frame.frame)));
        });
        bus->attach(a);
        bus->attach(b);
    }
    /// Lets `us` pass on both clocks, then reads and acts.
    void step(std::uint64_t us) {
        now.us += us;
        system.realtime_us += us;
        bus->poll(now);
        bus->advance(now);
    }
    void go_down() {
        system.up = false;
        system.fail(socket_of_a, ENETDOWN);
        step(10);
    }
    void come_back(unsigned number) {
        system.number = number;
        system.up = true;
        step(100000);
    }

    FakeCanSystem system;
    PlainNode a{"a"};
    PlainNode b{"b"};
    std::unique_ptr<SocketCanBus> bus;
    Instant now{1000000};
    std::vector<std::string> log;
};

}  // namespace

TEST_F(SocketCanRestart, BusOffControllerIsNotRestartedAfterItsInterfaceReturned) {
    system.arrive_error(socket_of_a, CAN_ERR_BUSOFF, 0);
    step(10);
    go_down();
    come_back(3);
    step(1000000);
    EXPECT_EQ(system.restarts, 0);
    EXPECT_EQ(bus->next_deadline(), never);
}

TEST_F(SocketCanRestart, RefusedRestartIsReportedAgainAfterTheInterfaceReturned) {
    std::vector<std::string> refusals;
    bus->on_notice([&](const std::string& text) {
        if (text.find("refuses the restart") != std::string::npos) {
            refusals.push_back(text);
        }
    });
    system.restart_answer = false;
    for (std::size_t life = 1; life <= 2; ++life) {
        for (int frame = 0; frame < 2; ++frame) {  // the second error frame reports the same bus-off
            system.arrive_error(socket_of_a, CAN_ERR_BUSOFF, 0);
            step(10);
            step(500000);
        }
        EXPECT_THAT(refusals, SizeIs(life));
        go_down();
        come_back(3);
    }
}

TEST_F(SocketCanRestart, MissingEchoIsNotMatchedWithANewFrame) {
    a.send("703#05");
    step(10);
    go_down();
    come_back(9);
    system.arrive(monitor + sockets_of_a_life, "703#05", system.realtime_us);
    step(10);
    EXPECT_THAT(log, ElementsAre("- 703#05"));
    EXPECT_EQ(bus->report(now).worst_latency.us, 0U);
}

TEST_F(SocketCanRestart, WaitingUserFrameIsNotSentAfterARestart) {
    system.sockets[monitor].send_answers = {ENOBUFS};
    bus->put(parse_frame("000#0100", "test"), now);
    step(10);
    go_down();
    come_back(3);
    step(100000);
    EXPECT_THAT(system.sockets[monitor].sent, IsEmpty());
}

TEST_F(SocketCanRestart, EarlierControllerNotificationsDoNotEndBusOff) {
    system.arrive_error(socket_of_a, CAN_ERR_RESTARTED, 0);
    go_down();
    ASSERT_THAT(a.states, SizeIs(1));
    EXPECT_THAT(a.states[0], testing::HasSubstr(" 3"));
    come_back(3);
    ASSERT_THAT(a.states, SizeIs(2));
    EXPECT_THAT(a.states[1], testing::HasSubstr(" 0"));
}

TEST_F(SocketCanRestart, RetryPauseIsResetByARestart) {
    system.sockets[socket_of_a].send_answers = {ENOBUFS, ENOBUFS, ENOBUFS};
    a.send("703#05");
    step(10);
    step(1000);
    step(2000);  // without the restart, the next attempt would follow 4 ms later
    go_down();
    come_back(3);
    system.sockets[socket_of_a].send_answers = {ENOBUFS};
    a.send("703#05");
    step(10);
    EXPECT_EQ(bus->next_deadline().us, now.us + 1000);  // the pause starts at 1 ms again
}

}  // namespace canproof::host::test
