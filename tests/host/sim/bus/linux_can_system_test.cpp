// SPDX-License-Identifier: Apache-2.0
// The system calls of raw CAN sockets, with a fake kernel in this process: it defines the calls of the C library and of
// libsocketcan that concern CAN. All other calls reach the real kernel.
#include "host/sim/bus/linux_can_system.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <libsocketcan.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <deque>
#include <map>
#include <set>

#include "tests/support/fake_kernel.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::FakeKernel;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class LinuxCan : public testing::Test {
  protected:
    LinuxCan() { FakeKernel::present() = &kernel; }
    ~LinuxCan() override { FakeKernel::present() = nullptr; }
    LinuxCan(const LinuxCan&) = delete;
    LinuxCan& operator=(const LinuxCan&) = delete;

    static can_frame frame_of(std::uint32_t id) {
        can_frame frame{};
        frame.can_id = id;
        frame.can_dlc = 2;
        frame.data[0] = 0xA5;
        return frame;
    }

    FakeKernel kernel;
    CanSystem& system{linux_can_system()};
};

}  // namespace

TEST_F(LinuxCan, SocketReportsTimestampsAndLosses_AndErrorFramesOnlyOnRequest) {
    CanOpening plain = system.open("vcan0", false);
    EXPECT_EQ(plain.error, 0);
    EXPECT_TRUE(plain.roomy);
    EXPECT_EQ(kernel.bound, (std::map<int, int>{{plain.socket.number(), 3}}));
    EXPECT_THAT(kernel.options, ElementsAre(fmt::format("{}:{}={}", SOL_SOCKET, SO_RCVBUFFORCE, receive_room),
                                            fmt::format("{}:{}=1", SOL_SOCKET, SO_TIMESTAMPNS),
                                            fmt::format("{}:{}=1", SOL_SOCKET, SO_RXQ_OVFL)));
    const CanOpening with_errors = system.open("vcan0", true);
    ASSERT_EQ(with_errors.error, 0);
    // the classes of linux/can/error.h: controller 4, bus-off 40h, restarted 100h
    EXPECT_EQ(kernel.options.back(), fmt::format("{}:{}={}", int{SOL_CAN_RAW}, int{CAN_RAW_ERR_FILTER}, 0x144));
    EXPECT_THAT(kernel.kinds,
                ElementsAre(SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC));
    const int number = plain.socket.number();
    EXPECT_TRUE(FakeKernel::is_open(number));
    plain.socket = {};
    EXPECT_FALSE(FakeKernel::is_open(number));
}

TEST_F(LinuxCan, SocketThatCannotBeOpenedReportsTheErrorAndLeavesNoDescriptor) {
    EXPECT_EQ(system.open("can7", false).error, ENODEV);
    kernel.bind_error = ENETDOWN;
    EXPECT_EQ(system.open("vcan0", false).error, ENETDOWN);
    kernel.bind_error = 0;
    for (const int option : {SO_TIMESTAMPNS, SO_RXQ_OVFL}) {
        kernel.refused = {option};
        EXPECT_EQ(system.open("vcan0", false).error, ENOPROTOOPT) << option;
    }
    kernel.refused = {CAN_RAW_ERR_FILTER};
    EXPECT_EQ(system.open("vcan0", true).error, ENOPROTOOPT);
    for (const int descriptor : kernel.opened) {
        EXPECT_FALSE(FakeKernel::is_open(descriptor)) << descriptor;
    }
    EXPECT_THAT(kernel.opened, SizeIs(5));
    kernel.socket_error = EAFNOSUPPORT;
    EXPECT_EQ(system.open("vcan0", false).error, EAFNOSUPPORT);
    EXPECT_FALSE(system.open("vcan0", false).socket.is_open());
}

TEST_F(LinuxCan, ReceiveBufferSmallerThanRequestedIsRecognised) {
    kernel.refused = {SO_RCVBUFFORCE};
    kernel.room = receive_room;
    const CanOpening enough = system.open("vcan0", false);
    EXPECT_TRUE(enough.roomy);
    EXPECT_THAT(kernel.options, Contains(fmt::format("{}:{}={}", SOL_SOCKET, SO_RCVBUF, receive_room)));
    kernel.room = receive_room - 1;
    const CanOpening little = system.open("vcan0", false);
    EXPECT_FALSE(little.roomy);
    kernel.refused = {SO_RCVBUFFORCE, SO_RCVBUF};
    const CanOpening none = system.open("vcan0", false);
    EXPECT_EQ(none.error, 0);  // a small buffer is no reason to refuse the interface
    EXPECT_FALSE(none.roomy);
}

TEST_F(LinuxCan, EachSetOfFiltersReplacesTheWholeList) {
    const CanOpening opened = system.open("vcan0", false);
    const int descriptor = opened.socket.number();
    EXPECT_EQ(system.set_filters(descriptor, {{0x603, 0x7FF}, {0x80000123U, 0x9FFFFFFFU}}), 0);
    ASSERT_THAT(kernel.filters, SizeIs(2));
    EXPECT_EQ(kernel.filters[0].can_id, 0x603U);
    EXPECT_EQ(kernel.filters[1].can_mask, 0x9FFFFFFFU);
    EXPECT_EQ(system.set_filters(descriptor, {}), 0);
    EXPECT_THAT(kernel.filters, IsEmpty());
    kernel.refused = {CAN_RAW_FILTER};
    EXPECT_EQ(system.set_filters(descriptor, {}), ENOPROTOOPT);
}

TEST_F(LinuxCan, FrameIsSentCompletely_AndAFailureReturnsItsErrorNumber) {
    CanOpening opened = system.open("vcan0", false);
    const int descriptor = opened.socket.number();
    EXPECT_EQ(system.send(descriptor, frame_of(0x703)), 0);
    can_frame sent{};
    ASSERT_EQ(recv(kernel.peers.at(descriptor), &sent, sizeof sent, MSG_DONTWAIT), static_cast<ssize_t>(sizeof sent));
    EXPECT_EQ(sent.can_id, 0x703U);
    EXPECT_EQ(sent.can_dlc, 2);
    EXPECT_EQ(sent.data[0], 0xA5);
    int full = 0;
    for (int i = 0; i < 100000 && full == 0; ++i) {
        full = system.send(descriptor, frame_of(0x703));
    }
    EXPECT_EQ(full, EAGAIN);
    opened.socket = {};
    EXPECT_EQ(system.send(descriptor, frame_of(0x703)), EBADF);
}

TEST_F(LinuxCan, FramesAreReceivedWithTheirTimestampsAndLossCounters) {
    const CanOpening opened = system.open("vcan0", false);
    const int descriptor = opened.socket.number();
    std::vector<CanReception> got;
    EXPECT_EQ(system.receive(descriptor, got), EAGAIN);
    EXPECT_THAT(got, IsEmpty());
    kernel.arriving = {{frame_of(0x703), {5, 7}, 0, false}, {frame_of(0x704), {6, 999999999}, 3, true}};
    EXPECT_EQ(system.receive(descriptor, got), 0);
    ASSERT_THAT(got, SizeIs(2));
    EXPECT_EQ(got[0].frame.can_id, 0x703U);
    EXPECT_EQ(got[0].stamp_ns, 5000000007U);
    EXPECT_EQ(got[0].dropped, 0U);
    EXPECT_EQ(got[1].frame.can_id, 0x704U);
    EXPECT_EQ(got[1].stamp_ns, 6999999999U);
    EXPECT_EQ(got[1].dropped, 3U);
    for (std::uint32_t id = 0; id < 100; ++id) {
        kernel.arriving.push_back({frame_of(id), {7, 0}, 0, false});
    }
    EXPECT_EQ(system.receive(descriptor, got), 0);  // appends; one call reads up to 64 frames
    EXPECT_EQ(system.receive(descriptor, got), 0);
    ASSERT_THAT(got, SizeIs(102));
    EXPECT_EQ(got[65].frame.can_id, 63U);
    EXPECT_EQ(got.back().frame.can_id, 99U);
    kernel.receive_error = ENETDOWN;
    EXPECT_EQ(system.receive(descriptor, got), ENETDOWN);
    kernel.dropped = 12;
    EXPECT_EQ(system.dropped(descriptor), 12U);
}

TEST_F(LinuxCan, InterfaceNumberAndUpFlagAreReadFromTheKernel) {
    EXPECT_EQ(system.interface_number("vcan0"), 3U);
    EXPECT_EQ(system.interface_number("can7"), 0U);
    EXPECT_TRUE(system.is_up("vcan0"));
    EXPECT_EQ(kernel.asked, "vcan0");
    kernel.flags = IFF_RUNNING;  // not IFF_UP
    EXPECT_FALSE(system.is_up("vcan0"));
    kernel.flags = IFF_UP;
    EXPECT_FALSE(system.is_up("can7"));
    for (const int descriptor : kernel.opened) {
        EXPECT_FALSE(FakeKernel::is_open(descriptor)) << descriptor;
    }
    kernel.socket_error = EAFNOSUPPORT;
    EXPECT_FALSE(system.is_up("vcan0"));
}

TEST_F(LinuxCan, BitRateIsSetWhileTheInterfaceIsStopped) {
    kernel.rate = 125000;
    EXPECT_EQ(system.bit_rate("vcan0"), 125000U);
    BitRateOutcome outcome = system.set_bit_rate("vcan0", 250000);
    EXPECT_TRUE(outcome.done);
    EXPECT_EQ(outcome.why, "");
    EXPECT_THAT(kernel.calls, ElementsAre("stop vcan0", "rate vcan0 250000", "start vcan0"));
    kernel.calls.clear();
    kernel.rate = 250000;
    EXPECT_TRUE(system.set_bit_rate("vcan0", 250000).done);
    EXPECT_THAT(kernel.calls, IsEmpty());
    kernel.failing = {"rate"};
    outcome = system.set_bit_rate("vcan0", 1);
    EXPECT_FALSE(outcome.done);
    EXPECT_THAT(outcome.why, HasSubstr("does not support this bit rate"));
    EXPECT_THAT(kernel.calls, ElementsAre("stop vcan0", "rate vcan0 1", "start vcan0"));
    kernel.failing = {"start"};
    outcome = system.set_bit_rate("vcan0", 125000);
    EXPECT_FALSE(outcome.done);
    EXPECT_THAT(outcome.why, HasSubstr("could not be switched on again"));
    kernel.failing = {"stop"};
    kernel.calls.clear();
    outcome = system.set_bit_rate("vcan0", 125000);
    EXPECT_FALSE(outcome.done);
    EXPECT_THAT(outcome.why, HasSubstr("CAP_NET_ADMIN"));
    EXPECT_THAT(kernel.calls, ElementsAre("stop vcan0"));
    kernel.rate = 0;
    outcome = system.set_bit_rate("vcan0", 125000);
    EXPECT_FALSE(outcome.done);
    EXPECT_THAT(outcome.why, HasSubstr("has no bit rate that can be set"));
    kernel.failing = {"get"};
    EXPECT_EQ(system.bit_rate("vcan0"), 0U);
}

TEST_F(LinuxCan, RestartReturnsWhetherTheKernelPermitsIt) {
    EXPECT_TRUE(system.restart("vcan0"));
    kernel.failing = {"restart"};
    EXPECT_FALSE(system.restart("vcan0"));
    EXPECT_THAT(kernel.calls, ElementsAre("restart vcan0", "restart vcan0"));
}

TEST_F(LinuxCan, MessagesOfLibsocketcanDoNotReachStandardError) {
    testing::internal::CaptureStderr();
    kernel.failing = {"get", "restart"};
    system.bit_rate("vcan0");
    system.restart("vcan0");
    static_cast<void>(!write(STDERR_FILENO, "own words", 9));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "own words");
}

}  // namespace canproof::host::test
