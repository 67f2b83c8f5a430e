#include "host/bus/socketcand_bus.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "host/bus/candump.hpp"

namespace canproof::host {

namespace {

constexpr int waiting_connections = 8;
constexpr int kernel_room =
    64 * 1024;  // bytes a client, beside the session's own bound: who does not read is found out

[[noreturn]] void refuse(const ListenAddress& address, const std::string& why) {
    throw InputError{
        fmt::format("cannot listen at {}:{} ({}); name a free address, as in --bus socketcand:127.0.0.1:29536",
                    address.host, address.port, why)};
}

/// A listening socket, non-blocking.
int listen_at(const ListenAddress& address) {
    addrinfo wish{};
    wish.ai_socktype = SOCK_STREAM;
    wish.ai_flags = AI_NUMERICHOST | AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const int unknown = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wish, &found);
    if (unknown != 0) {
        refuse(address, gai_strerror(unknown));
    }
    const int descriptor = socket(found->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;
    const bool sound = descriptor >= 0 && setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
                       bind(descriptor, found->ai_addr, found->ai_addrlen) == 0 &&
                       listen(descriptor, waiting_connections) == 0;
    const int error = errno;
    freeaddrinfo(found);
    if (!sound) {
        if (descriptor >= 0) {
            close(descriptor);
        }
        refuse(address, std::strerror(error));
    }
    return descriptor;
}

/// The port of a bound socket; IPv4 and IPv6 keep it at the same place.
std::uint16_t port_of(int descriptor) {
    sockaddr_storage general{};
    socklen_t size = sizeof general;
    getsockname(descriptor, reinterpret_cast<sockaddr*>(&general), &size);
    sockaddr_in address{};
    std::memcpy(&address, &general, sizeof address);
    return ntohs(address.sin_port);
}

}  // namespace

ListenAddress parse_listen_address(const std::string& text) {
    ListenAddress address;
    const auto colon = text.rfind(':');
    const bool bare_host = colon == std::string::npos || (!text.empty() && text.back() == ']');
    std::string host = bare_host ? text : text.substr(0, colon);
    const std::string port = bare_host ? "" : text.substr(colon + 1);
    if (host.size() >= 2 && host.front() == '[' && host.back() == ']') {
        host = host.substr(1, host.size() - 2);
    }
    if (!host.empty()) {
        address.host = host;
    }
    if (!port.empty()) {
        const bool number = port.size() < 6 && port.find_first_not_of("0123456789") == std::string::npos;
        if (!number || std::stoul(port) > 65535) {
            throw InputError{fmt::format("`{}` is no port; write socketcand:127.0.0.1:29536", port)};
        }
        address.port = static_cast<std::uint16_t>(std::stoul(port));
    }
    return address;
}

SocketcandBus::SocketcandBus(const ListenAddress& address, std::uint32_t bit_rate, const BusFaultRates& faults,
                             std::uint64_t epoch_us)
    : bus_{"can0", bit_rate, faults}, epoch_us_{epoch_us}, listener_{listen_at(address)}, port_{port_of(listener_)} {
    bus_.listen([this](const BusFrame& frame) { tell(frame); });
    bus_.on_notice([this](const std::string& text) { notice(text); });
}

SocketcandBus::~SocketcandBus() {
    for (Client& client : clients_) {
        bus_.detach_gateway(client.session->gateway());
        close(client.descriptor);
    }
    close(listener_);
}

std::vector<Watch> SocketcandBus::watches() const {
    std::vector<Watch> all;
    if (clients_.size() < most_clients) {
        all.push_back({listener_, true, false});
    }
    for (const Client& client : clients_) {
        const bool writes = !client.session->output().empty();
        const bool reads = client.session->wants_input() && !client.ended;
        if (reads || writes) {
            all.push_back({client.descriptor, reads, writes});
        }
    }
    return all;
}

Instant SocketcandBus::poll(Instant now) {
    accept_clients();
    for (Client& client : clients_) {
        read_client(client, now);
        write_client(client);
    }
    drop_gone_clients();
    return now;
}

void SocketcandBus::accept_clients() {
    while (clients_.size() < most_clients) {
        const int descriptor = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (descriptor < 0) {
            return;
        }
        const int on = 1;
        setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &kernel_room, sizeof kernel_room);
        Client client;
        client.descriptor = descriptor;
        client.name = fmt::format("client {}", descriptor);
        client.session = std::make_unique<SocketcandSession>(client.name, epoch_us_);
        bus_.attach_gateway(client.session->gateway());
        clients_.push_back(std::move(client));
    }
}

/// One piece a client and turn: who sends without end takes no more than this from the others.
void SocketcandBus::read_client(Client& client, Instant now) {
    std::string_view got;
    std::array<char, SocketcandSession::input_limit> piece{};
    if (client.session->wants_input() && !client.ended) {
        const ssize_t count = recv(client.descriptor, piece.data(), piece.size(), 0);
        client.ended = count == 0;
        client.gone = count < 0 && errno != EAGAIN && errno != EINTR;
        got = count > 0 ? std::string_view{piece.data(), static_cast<std::size_t>(count)} : got;
    }
    client.session->receive(got, now);
}

void SocketcandBus::write_client(Client& client) {
    const std::string& text = client.session->output();
    if (!client.gone && !text.empty()) {
        const ssize_t count = send(client.descriptor, text.data(), text.size(), MSG_NOSIGNAL);
        if (count > 0) {
            client.session->sent(static_cast<std::size_t>(count));
        } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
            client.gone = true;
        }
    }
    if (client.session->is_dropped() && !client.gone) {
        notice(fmt::format("{} was dropped: {}", client.name, client.session->dropped_because()));
        client.gone = true;
    }
    client.gone = client.gone || (client.ended && client.session->gateway().next_frame() == nullptr);
}

void SocketcandBus::drop_gone_clients() {
    for (Client& client : clients_) {
        if (client.gone) {
            bus_.detach_gateway(client.session->gateway());
            close(client.descriptor);
        }
    }
    clients_.erase(std::remove_if(clients_.begin(), clients_.end(), [](const Client& client) { return client.gone; }),
                   clients_.end());
}

void SocketcandBus::advance(Instant now) {
    bus_.advance(now);
    bool any = false;
    for (Client& client : clients_) {
        client.session->advance(now);
        any = client.session->receive({}, now) || any;  // the bus may have made room for what waits
    }
    if (any) {
        bus_.advance(now);
    }
    for (Client& client : clients_) {
        write_client(client);
    }
    drop_gone_clients();
}

Instant SocketcandBus::next_deadline() const {
    Instant next = bus_.next_deadline();
    for (const Client& client : clients_) {
        next = earliest(next, client.session->next_deadline());
    }
    return next;
}

}  // namespace canproof::host
