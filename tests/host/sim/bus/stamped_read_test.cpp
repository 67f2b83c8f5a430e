// SPDX-License-Identifier: Apache-2.0
// Data of a real socket with the kernel's time stamps of reception, and without them.
#include "host/sim/bus/stamped_read.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <ctime>

namespace canproof::host::test {

namespace {

/// A datagram socket on the loopback that sends to itself.
class OwnSocket {
  public:
    OwnSocket() {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), size), 0);
        EXPECT_EQ(getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size), 0);
        EXPECT_EQ(connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    }
    ~OwnSocket() { close(descriptor_); }
    OwnSocket(const OwnSocket&) = delete;
    OwnSocket& operator=(const OwnSocket&) = delete;

    int descriptor() const { return descriptor_; }
    StampedRead sent_and_read(const std::string& text) const {
        EXPECT_EQ(send(descriptor_, text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
        std::array<char, 16> into{};
        return receive_stamped(descriptor_, into.data(), into.size());
    }

  private:
    int descriptor_{socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
};

/// Control data of a message, put together by hand.
class ControlData {
  public:
    void add(int level, int type, const timespec& value) {
        alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof value)> one{};
        cmsghdr head{};
        head.cmsg_level = level;
        head.cmsg_type = type;
        head.cmsg_len = CMSG_LEN(sizeof value);
        std::memcpy(one.data(), &head, sizeof head);
        std::memcpy(one.data() + CMSG_LEN(0), &value, sizeof value);
        std::memcpy(bytes_.data() + used_, one.data(), one.size());
        used_ += one.size();
    }
    std::uint64_t stamp_ns() {
        msghdr message{};
        message.msg_control = bytes_.data();
        message.msg_controllen = used_;
        return receive_stamp_ns(message);
    }

  private:
    alignas(cmsghdr) std::array<char, 3 * CMSG_SPACE(sizeof(timespec))> bytes_{};
    std::size_t used_{0};
};

}  // namespace

TEST(StampedRead, DataHaveATimeStampOnlyWhenItIsRequested) {
    const OwnSocket plain;
    const StampedRead without = plain.sent_and_read("ab");
    EXPECT_EQ(without.count, 2);
    EXPECT_EQ(without.stamp_ns, 0U);
    const OwnSocket stamped;
    ask_for_stamps(stamped.descriptor());
    for (const char* const text : {"a", "ab"}) {
        const StampedRead with = stamped.sent_and_read(text);
        EXPECT_EQ(with.count, static_cast<ssize_t>(std::strlen(text)));
        EXPECT_NE(with.stamp_ns, 0U) << text;
    }
}

TEST(StampedRead, ReadWithoutDataHasNoTimeStamp) {
    const OwnSocket stamped;
    ask_for_stamps(stamped.descriptor());
    const StampedRead empty = stamped.sent_and_read("");
    EXPECT_EQ(empty.count, 0);
    EXPECT_EQ(empty.stamp_ns, 0U);
    char byte = 0;
    const StampedRead nothing = receive_stamped(stamped.descriptor(), &byte, 1);
    EXPECT_EQ(nothing.count, -1);
    EXPECT_EQ(nothing.stamp_ns, 0U);
}

TEST(StampedRead, ControlDataOfAnotherKindAreNotReadAsATimeStamp) {
    ControlData control;
    EXPECT_EQ(control.stamp_ns(), 0U);
    control.add(SOL_SOCKET, SO_RXQ_OVFL, {1, 1});
    control.add(IPPROTO_IP, SO_TIMESTAMPNS, {2, 2});
    EXPECT_EQ(control.stamp_ns(), 0U);
    control.add(SOL_SOCKET, SO_TIMESTAMPNS, {3, 4});
    EXPECT_EQ(control.stamp_ns(), 3000000004U);
}

}  // namespace canproof::host::test
