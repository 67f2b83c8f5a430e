// SPDX-License-Identifier: Apache-2.0
// A socketcand server on the loopback that sends the text given by a test.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>

namespace canproof::host::test {

class ScriptedServer {
  public:
    /// Listens on a port that the kernel chooses.
    ScriptedServer() : listener_{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(bind(listener_, reinterpret_cast<const sockaddr*>(&address), size), 0);
        EXPECT_EQ(listen(listener_, 4), 0);
        EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
        port_ = ntohs(address.sin_port);
    }
    ~ScriptedServer() {
        hang_up();
        close(listener_);
    }
    ScriptedServer(const ScriptedServer&) = delete;
    ScriptedServer& operator=(const ScriptedServer&) = delete;

    std::uint16_t port() const { return port_; }
    /// Waits for the next client.
    void accept_one() {
        hang_up();
        client_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        EXPECT_GE(client_, 0);
        const int on = 1;  // otherwise a short text can wait 40 ms for the acknowledgement of the one before
        EXPECT_EQ(setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on), 0);
        heard_.clear();
    }
    void say(const std::string& text) const {
        EXPECT_EQ(send(client_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }
    /// Makes the buffer for text of the client small, so that it is soon full.
    void keep_little() const {
        const int room = 4096;
        EXPECT_EQ(setsockopt(client_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room), 0);
    }
    /// Returns all text that the client has sent so far.
    const std::string& heard() {
        std::array<char, 4096> piece{};
        for (ssize_t count = 1; count > 0;) {
            count = recv(client_, piece.data(), piece.size(), MSG_DONTWAIT);
            heard_.append(piece.data(), count > 0 ? static_cast<std::size_t>(count) : 0U);
        }
        return heard_;
    }
    /// Returns whether the client has closed the connection.
    bool ended() {
        heard();
        char byte = 0;
        return recv(client_, &byte, 1, MSG_DONTWAIT) == 0;
    }
    /// Resets the connection, so that the next call of the client fails.
    void reset_connection() {
        const linger at_once{1, 0};
        EXPECT_EQ(setsockopt(client_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once), 0);
        close(client_);
        client_ = -1;
    }
    /// Closes the connection. Text sent before still arrives.
    void hang_up() {
        if (client_ >= 0) {
            heard();
            close(client_);
            client_ = -1;
        }
    }

  private:
    int listener_;
    int client_{-1};
    std::uint16_t port_{0};
    std::string heard_;
};

}  // namespace canproof::host::test
