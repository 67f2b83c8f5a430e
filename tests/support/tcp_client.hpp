// SPDX-License-Identifier: Apache-2.0
// A TCP client for tests: sends text to a server on this machine over a real socket, and collects the answers.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <string>

namespace canproof::test {

class TcpClient {
  public:
    /// Connects to a TCP port of this machine.
    explicit TcpClient(std::uint16_t port) : descriptor_{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
        const int room = 32 * 1024;  // a small receive buffer, in bytes: it is soon full when the client does not read
        setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }
    ~TcpClient() { hang_up(); }
    TcpClient(const TcpClient&) = delete;
    TcpClient& operator=(const TcpClient&) = delete;

    void say(const std::string& text) const {
        EXPECT_EQ(send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }
    /// Sends as much text as the buffers can take without waiting. Returns false when the buffers are full.
    bool push(const std::string& text) const {
        return send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) > 0;
    }
    /// Returns all text received so far.
    const std::string& heard() {
        std::array<char, 65536> piece{};
        for (ssize_t count = 1; count > 0;) {
            count = recv(descriptor_, piece.data(), piece.size(), MSG_DONTWAIT);
            heard_.append(piece.data(), count > 0 ? static_cast<std::size_t>(count) : 0U);
            ended_ = ended_ || count == 0 || (count < 0 && errno != EAGAIN);
        }
        return heard_;
    }
    /// Returns whether the server has closed the connection.
    bool ended() {
        heard();
        return ended_;
    }
    /// Waits until data arrive, but for at most `milliseconds`.
    void wait(int milliseconds) const {
        pollfd waiting{descriptor_, POLLIN, 0};
        ::poll(&waiting, 1, milliseconds);
    }
    /// Ends the connection with a reset, like a machine that was switched off and restarted.
    void reset() {
        const linger at_once{1, 0};
        EXPECT_EQ(setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once), 0);
        hang_up();
    }
    void hang_up() {
        if (descriptor_ >= 0) {
            close(descriptor_);
            descriptor_ = -1;
        }
    }

  private:
    int descriptor_;
    std::string heard_;
    bool ended_{false};
};

}  // namespace canproof::test
