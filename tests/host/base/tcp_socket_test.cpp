// SPDX-License-Identifier: Apache-2.0
// TCP sockets of the loopback: addresses, listening, clients, connections, and what is reported when a call fails.
#include "host/base/tcp_socket.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>

#include <cerrno>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/base/input_error.hpp"
#include "tests/support/descriptor_limit.hpp"
#include "tests/support/fake_kernel.hpp"
#include "tests/support/tcp_client.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::FakeKernel;
using canproof::test::TcpClient;
using testing::StartsWith;

constexpr int longest_wait_ms = 5000;  // reached only in a broken test
const AddressUse ask{"ask box", "ask another"};

std::string refusal(const std::function<void()>& deed) {
    try {
        deed();
    } catch (const InputError& refused) {
        return refused.what();
    }
    return "";
}

Listener listen_on_loopback(std::uint16_t port = 0) {
    return listen_at("127.0.0.1", port, 4, "name another");
}

bool becomes(const Descriptor& socket, short event) {
    pollfd waiting{socket.number(), event, 0};
    return ::poll(&waiting, 1, longest_wait_ms) == 1;
}

int option(const Descriptor& socket, int level, int which) {
    int value = -1;
    socklen_t size = sizeof value;
    EXPECT_EQ(getsockopt(socket.number(), level, which, &value, &size), 0);
    return value;
}

bool never_waits(const Descriptor& socket) {
    return (fcntl(socket.number(), F_GETFL) & O_NONBLOCK) != 0 && fcntl(socket.number(), F_GETFD) == FD_CLOEXEC;
}

SocketAddress address_of(const Listener& listener) {
    return find_address("127.0.0.1", listener.port, HostForm::number, ask);
}

/// Lets calls of the C library fail.
class FailingKernel : public testing::Test {
  protected:
    FailingKernel() { FakeKernel::present() = &kernel; }
    ~FailingKernel() override { FakeKernel::present() = nullptr; }
    FailingKernel(const FailingKernel&) = delete;
    FailingKernel& operator=(const FailingKernel&) = delete;

    FakeKernel kernel;
};

int lowest_free_descriptor() {
    return Descriptor{dup(STDIN_FILENO)}.number();
}

}  // namespace

TEST(TcpSocket, AddressIsThatOfTheHostAndThePort) {
    const SocketAddress four = find_address("127.0.0.2", 0x1234, HostForm::number, ask);
    sockaddr_in address{};
    ASSERT_EQ(four.size, sizeof address);
    std::memcpy(&address, &four.bytes, sizeof address);
    EXPECT_EQ(address.sin_family, AF_INET);
    EXPECT_EQ(ntohl(address.sin_addr.s_addr), 0x7F000002U);
    EXPECT_EQ(ntohs(address.sin_port), 0x1234U);
    const SocketAddress six = find_address("::1", 80, HostForm::number, ask);
    EXPECT_EQ(six.bytes.ss_family, AF_INET6);
    EXPECT_EQ(six.size, sizeof(sockaddr_in6));
    EXPECT_NE(find_address("localhost", 80, HostForm::name_or_number, ask).size, 0U);
}

TEST(TcpSocket, UnknownHostIsReportedWithTheReasonAndTheRemedy) {
    EXPECT_EQ(refusal([] { find_address("localhost", 80, HostForm::number, ask); }),
              "cannot ask box (Name or service not known); ask another");
    const DescriptorLimit limit{lowest_free_descriptor()};
    EXPECT_EQ(refusal([] { find_address("localhost", 80, HostForm::name_or_number, ask); }),
              "cannot ask box (Too many open files); ask another");
}

TEST(TcpSocket, ListenerHasAFreePortAndNeverWaits) {
    const Listener first = listen_on_loopback();
    const Listener second = listen_on_loopback();
    EXPECT_NE(first.port, 0U);
    EXPECT_NE(first.port, second.port);
    EXPECT_TRUE(never_waits(first.socket));
    EXPECT_EQ(option(first.socket, SOL_SOCKET, SO_REUSEADDR), 1);
    EXPECT_FALSE(accept_client(first.socket).is_open());  // nobody waits
}

TEST(TcpSocket, PortInUseIsReportedWithTheAddressTheReasonAndTheRemedy) {
    const Listener first = listen_on_loopback();
    EXPECT_EQ(refusal([&] { listen_on_loopback(first.port); }),
              fmt::format("cannot listen at 127.0.0.1:{} (Address already in use); name another", first.port));
    EXPECT_THAT(refusal([] { listen_at("localhost", 0, 4, "name another"); }),
                StartsWith("cannot listen at localhost:0 (Name or service not known); "));
    const DescriptorLimit limit{lowest_free_descriptor()};
    EXPECT_EQ(refusal([] { listen_on_loopback(); }),
              "cannot listen at 127.0.0.1:0 (Too many open files); name another");
}

TEST_F(FailingKernel, FailedCallIsReportedAndLeavesNoDescriptor) {
    const int before = lowest_free_descriptor();
    kernel.refused = {SO_REUSEADDR};
    EXPECT_EQ(refusal([] { listen_on_loopback(); }),
              "cannot listen at 127.0.0.1:0 (Protocol not available); name another");
    kernel.refused = {};
    for (const char* const call : {"listen", "getsockname"}) {
        kernel.errors = {{call, ENOBUFS}};
        EXPECT_EQ(refusal([] { listen_on_loopback(); }),
                  "cannot listen at 127.0.0.1:0 (No buffer space available); name another")
            << call;
    }
    EXPECT_EQ(lowest_free_descriptor(), before);
}

TEST(TcpSocket, ClientIsAcceptedOnceAndItsTextsLeaveAtOnce) {
    const Listener listener = listen_on_loopback();
    TcpClient client{listener.port};
    ASSERT_TRUE(becomes(listener.socket, POLLIN));
    const Descriptor accepted = accept_client(listener.socket);
    ASSERT_TRUE(accepted.is_open());
    EXPECT_TRUE(never_waits(accepted));
    EXPECT_EQ(option(accepted, IPPROTO_TCP, TCP_NODELAY), 1);
    EXPECT_FALSE(accept_client(listener.socket).is_open());
    EXPECT_EQ(send_some(accepted, "hello"), 5U);
    client.wait(longest_wait_ms);
    EXPECT_EQ(client.heard(), "hello");
}

TEST(TcpSocket, ConnectionIsEstablishedWithAServerThatListens) {
    const Listener listener = listen_on_loopback();
    const StartedConnection started = start_connecting(address_of(listener));
    ASSERT_TRUE(started.socket.is_open());
    EXPECT_EQ(started.error, 0);
    EXPECT_TRUE(never_waits(started.socket));
    EXPECT_EQ(option(started.socket, IPPROTO_TCP, TCP_NODELAY), 1);
    ASSERT_TRUE(becomes(started.socket, POLLOUT));
    const ConnectionState state = connection_state(started.socket);
    EXPECT_TRUE(state.established);
    EXPECT_EQ(state.error, 0);
    EXPECT_TRUE(accept_client(listener.socket).is_open());
}

TEST(TcpSocket, ConnectionWithoutAServerEndsWithTheReason) {
    SocketAddress nobody;
    {
        const Listener listener = listen_on_loopback();
        nobody = address_of(listener);
    }
    const StartedConnection started = start_connecting(nobody);
    ASSERT_TRUE(started.socket.is_open());
    ASSERT_TRUE(becomes(started.socket, POLLOUT));
    const ConnectionState state = connection_state(started.socket);
    EXPECT_FALSE(state.established);
    EXPECT_EQ(state.error, ECONNREFUSED);
    const ConnectionState later = connection_state(started.socket);  // the kernel reports the reason only once
    EXPECT_FALSE(later.established);
    EXPECT_EQ(later.error, 0);
    EXPECT_EQ(connection_state(Descriptor{}).error, EBADF);
}

TEST(TcpSocket, ConnectionThatCannotBeStartedHasAReasonAndNoSocket) {
    // the kernel refuses to connect a TCP socket to the broadcast address
    const StartedConnection nowhere = start_connecting(find_address("255.255.255.255", 80, HostForm::number, ask));
    EXPECT_FALSE(nowhere.socket.is_open());
    EXPECT_NE(nowhere.error, 0);
    const SocketAddress somewhere = find_address("127.0.0.1", 80, HostForm::number, ask);
    const DescriptorLimit limit{lowest_free_descriptor()};
    const StartedConnection none = start_connecting(somewhere);
    EXPECT_FALSE(none.socket.is_open());
    EXPECT_EQ(none.error, EMFILE);
}

TEST(TcpSocket, TextIsSentAsFarAsThereIsRoom) {
    const Listener listener = listen_on_loopback();
    auto client = std::make_unique<TcpClient>(listener.port);
    ASSERT_TRUE(becomes(listener.socket, POLLIN));
    const Descriptor accepted = accept_client(listener.socket);
    const std::string much(std::size_t{1} << 26U, 'x');
    const auto first = send_some(accepted, much);
    ASSERT_TRUE(first.has_value());
    EXPECT_GT(*first, 0U);
    EXPECT_LT(*first, much.size());
    std::optional<std::size_t> next = first;
    for (int i = 0; i < 10000 && next.value_or(0) != 0; ++i) {
        next = send_some(accepted, much);
    }
    EXPECT_EQ(next, 0U);  // the client does not read
    client.reset();
    ASSERT_TRUE(becomes(accepted, POLLHUP));
    EXPECT_EQ(send_some(accepted, "x"), std::nullopt);
    EXPECT_THAT(errno, testing::AnyOf(ECONNRESET, EPIPE));
}

TEST(TcpSocket, OptionOfAClosedSocketCannotBeSet) {
    EXPECT_FALSE(switch_on(-1, SOL_SOCKET, SO_REUSEADDR));
    EXPECT_EQ(errno, EBADF);
}

}  // namespace canproof::host::test
