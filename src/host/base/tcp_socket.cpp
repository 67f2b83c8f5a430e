// SPDX-License-Identifier: Apache-2.0
#include "host/base/tcp_socket.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

constexpr int never_waits = SOCK_NONBLOCK | SOCK_CLOEXEC;

const sockaddr* general(const SocketAddress& address) {
    return reinterpret_cast<const sockaddr*>(&address.bytes);
}

std::string reason(int error) {
    return std::strerror(error);
}

Descriptor new_socket(const SocketAddress& address) {
    return Descriptor{socket(address.bytes.ss_family, SOCK_STREAM | never_waits, 0)};
}

/// Lets small texts leave at once. When this fails, they only leave later.
void send_without_delay(const Descriptor& socket) {
    static_cast<void>(switch_on(socket.number(), IPPROTO_TCP, TCP_NODELAY));
}

/// Returns the port of a bound socket. The port is in the same place for IPv4 and IPv6.
std::uint16_t port_of(const Descriptor& socket, const AddressUse& use) {
    SocketAddress own;
    own.size = sizeof own.bytes;
    if (getsockname(socket.number(), reinterpret_cast<sockaddr*>(&own.bytes), &own.size) != 0) {
        refuse_address(use, reason(errno));
    }
    sockaddr_in address{};
    std::memcpy(&address, &own.bytes, sizeof address);
    return ntohs(address.sin_port);
}

}  // namespace

void refuse_address(const AddressUse& use, const std::string& reason) {
    throw InputError{fmt::format("cannot {} ({}); {}", use.deed, reason, use.remedy)};
}

SocketAddress find_address(const std::string& host, std::uint16_t port, HostForm form, const AddressUse& use) {
    addrinfo wish{};
    wish.ai_socktype = SOCK_STREAM;
    wish.ai_flags = AI_NUMERICSERV | (form == HostForm::number ? AI_NUMERICHOST : 0);
    addrinfo* results = nullptr;
    const int unknown = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wish, &results);
    if (unknown != 0) {
        refuse_address(use, unknown == EAI_SYSTEM ? reason(errno) : gai_strerror(unknown));
    }
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> found{results, &freeaddrinfo};
    SocketAddress address;
    address.size = found->ai_addrlen;
    std::memcpy(&address.bytes, found->ai_addr, found->ai_addrlen);
    return address;
}

Listener listen_at(const std::string& host, std::uint16_t port, int most_waiting, const std::string& remedy) {
    const AddressUse use{fmt::format("listen at {}:{}", host, port), remedy};
    const SocketAddress address = find_address(host, port, HostForm::number, use);
    Listener listener;
    listener.socket = new_socket(address);
    const int number = listener.socket.number();
    // Without SO_REUSEADDR, the port cannot be used again for about a minute after the server has ended.
    if (!listener.socket.is_open() || !switch_on(number, SOL_SOCKET, SO_REUSEADDR) ||
        bind(number, general(address), address.size) != 0 || listen(number, most_waiting) != 0) {
        refuse_address(use, reason(errno));
    }
    listener.port = port_of(listener.socket, use);
    return listener;
}

Descriptor accept_client(const Descriptor& listener) {
    Descriptor client{accept4(listener.number(), nullptr, nullptr, never_waits)};
    if (client.is_open()) {
        send_without_delay(client);
    }
    return client;
}

StartedConnection start_connecting(const SocketAddress& server) {
    StartedConnection started{new_socket(server), 0};
    if (!started.socket.is_open()) {
        started.error = errno;
        return started;
    }
    send_without_delay(started.socket);
    if (connect(started.socket.number(), general(server), server.size) != 0 && errno != EINPROGRESS) {
        started.error = errno;
        started.socket = {};
    }
    return started;
}

ConnectionState connection_state(const Descriptor& socket) {
    ConnectionState state;
    socklen_t size = sizeof state.error;
    if (getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &state.error, &size) != 0) {
        state.error = errno;
    }
    SocketAddress peer;
    peer.size = sizeof peer.bytes;
    state.established =
        state.error == 0 && getpeername(socket.number(), reinterpret_cast<sockaddr*>(&peer.bytes), &peer.size) == 0;
    return state;
}

std::optional<std::size_t> send_some(const Descriptor& socket, std::string_view text) {
    const ssize_t count = send(socket.number(), text.data(), text.size(), MSG_NOSIGNAL);
    if (count >= 0) {
        return static_cast<std::size_t>(count);
    }
    return errno == EAGAIN || errno == EINTR ? std::optional<std::size_t>{0} : std::nullopt;
}

bool switch_on(int descriptor, int level, int option) {
    const int on = 1;
    return setsockopt(descriptor, level, option, &on, sizeof on) == 0;
}

}  // namespace canproof::host
