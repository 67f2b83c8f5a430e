// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcand_bus.hpp"

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/stamped_read.hpp"

namespace canproof::host {

namespace {

constexpr int waiting_connections = 8;
// Send buffer of the kernel for each client, in bytes. A small buffer is soon full when a client does not read. The
// unread text then reaches SocketcandSession::output_limit, and the client is dropped.
constexpr int kernel_room = 64 * 1024;

/// Sets options of a socket. The socket works without them, so a failure is ignored.
void set_options(int descriptor) {
    const auto set = [&](int level, int option, int value) {
        static_cast<void>(setsockopt(descriptor, level, option, &value, sizeof value));
    };
    set(SOL_SOCKET, SO_SNDBUF, kernel_room);
    static_cast<void>(switch_on(descriptor, SOL_SOCKET, SO_KEEPALIVE));
    ask_for_stamps(descriptor);
    set(IPPROTO_TCP, TCP_KEEPIDLE, SocketcandBus::keepalive_idle);
    set(IPPROTO_TCP, TCP_KEEPINTVL, SocketcandBus::keepalive_interval);
    set(IPPROTO_TCP, TCP_KEEPCNT, SocketcandBus::keepalive_questions);
}

}  // namespace

ListenAddress parse_listen_address(const std::string& text) {
    ListenAddress address;
    const auto colon = text.rfind(':');
    const bool bare_host = colon == std::string::npos || text.back() == ']';
    std::string host = bare_host ? text : text.substr(0, colon);
    const std::string port = bare_host ? "" : text.substr(colon + 1);
    if (!host.empty() && host.front() == '[' && host.back() == ']') {
        host = host.substr(1, host.size() - 2);
    }
    if (!host.empty()) {
        address.host = host;
    }
    if (!port.empty()) {
        const bool number = port.size() < 6 && port.find_first_not_of("0123456789") == std::string::npos;
        if (!number || std::stoul(port) > 65535) {
            throw InputError{
                fmt::format("`{}` is no port; write a number from 0 to 65535, as in socketcand:127.0.0.1:29536", port)};
        }
        address.port = static_cast<std::uint16_t>(std::stoul(port));
    }
    return address;
}

SocketcandBus::SocketcandBus(const ListenAddress& address, std::uint32_t bit_rate, const BusFaultRates& faults,
                             std::uint64_t epoch_us)
    : bus_{"can0", bit_rate, faults},
      epoch_us_{epoch_us},
      listener_{listen_at(address.host, address.port, waiting_connections,
                          "name another address, as in --bus socketcand:127.0.0.1:29536")} {
    bus_.listen([this](const BusFrame& frame) {
        tell(frame);
        tell_remote_frame(frame.frame);
    });
    bus_.on_notice([this](const std::string& text) { notice(text); });
}

std::vector<Watch> SocketcandBus::watches() const {
    std::vector<Watch> all{{listener_.socket.number(), true, false}};
    for (const Client& client : clients_) {
        const bool writes = !client.session->output().empty();
        if (client.reads() || writes) {
            all.push_back({client.socket.number(), client.reads(), writes});
        }
    }
    return all;
}

std::size_t SocketcandBus::clients() const {
    return static_cast<std::size_t>(
        std::count_if(clients_.begin(), clients_.end(), [](const Client& one) { return !one.leaves(); }));
}

Instant SocketcandBus::poll(Instant now) {
    accept_clients(now);
    arrival_clock().compare(now, kernel_realtime_ns);
    for (Client& client : clients_) {
        read_client(client, now);
        write_client(client);
    }
    drop_gone_clients();
    return now;
}

void SocketcandBus::accept_clients(Instant now) {
    for (int i = 0; i < waiting_connections; ++i) {
        Descriptor socket = accept_client(listener_.socket);
        if (!socket.is_open()) {
            return;
        }
        take_client(std::move(socket), now);
    }
}

void SocketcandBus::take_client(Descriptor socket, Instant now) {
    set_options(socket.number());
    Client client;
    client.name = fmt::format("client {}", socket.number());
    client.socket = std::move(socket);
    client.session = std::make_unique<SocketcandSession>(client.name, epoch_us_);
    client.joined_at = now;
    if (clients() == most_clients && !make_place(now)) {
        const std::string why = fmt::format("{} clients have joined, which is the most", most_clients);
        if (!refusal_told_) {
            notice("a client of socketcand was refused: " + why);
        }
        refusal_told_ = true;
        send_away(client, why + "; try again when one has left", now);
    } else {
        bus_.attach_gateway(client.session->gateway());
    }
    clients_.push_back(std::move(client));
}

/// Makes room for a new client: dismisses the first client that has not opened the bus within `patience`. Returns false
/// when there is no such client.
bool SocketcandBus::make_place(Instant now) {
    const auto idle = std::find_if(clients_.begin(), clients_.end(),
                                   [&](const Client& one) { return one.is_idle() && one.joined_at + patience <= now; });
    if (idle != clients_.end()) {
        send_away(*idle, "another client needs the place, and this one has not opened the bus", now);
    }
    return idle != clients_.end();
}

void SocketcandBus::send_away(Client& client, const std::string& why, Instant now) const {
    client.session->send_away(why);
    client.closes_at = now + leave_limit;
}

void SocketcandBus::end_idle_clients(Instant now) {
    for (Client& client : clients_) {
        if (client.is_idle() && client.joined_at + open_limit <= now) {
            send_away(client, fmt::format("the bus was not opened within {} s", open_limit.us / 1000000U), now);
        }
        client.gone = client.closes_at <= now;
    }
    const auto leaving = static_cast<std::size_t>(
        std::count_if(clients_.begin(), clients_.end(), [](const Client& one) { return one.leaves(); }));
    std::size_t too_many = leaving > most_clients ? leaving - most_clients : 0;
    for (std::size_t i = 0; too_many > 0; ++i) {
        if (clients_[i].leaves()) {
            clients_[i].gone = true;
            --too_many;
        }
    }
}

void SocketcandBus::tell_remote_frame(const Frame& frame) {
    if (frame.remote && !remote_frame_told_ && clients() != 0) {
        remote_frame_told_ = true;
        notice(
            fmt::format("{} is a remote frame, which socketcand's protocol does not have: its clients do not receive "
                        "it; node guarding by another program needs --bus socketcan:vcan0",
                        format_frame(frame)));
    }
}

/// Reads at most one buffer of text from the client. So a client that sends all the time cannot block the others.
/// take_arrivals() passes the text on at its time of arrival.
void SocketcandBus::read_client(Client& client, Instant now) {
    if (!client.reads()) {
        return;
    }
    std::array<char, SocketcandSession::input_limit> piece{};
    const StampedRead got = receive_stamped(client.socket.number(), piece.data(), piece.size());
    if (got.count <= 0) {
        client.ended = got.count == 0 || errno != EAGAIN;
    } else {
        client.arrived.assign(piece.data(), static_cast<std::size_t>(got.count));
        client.arrived_at = std::max(arrival_clock().of_read(got.stamp_ns, now), advanced_to_);
    }
}

/// Passes the text that has arrived up to `now` to the sessions.
void SocketcandBus::take_arrivals(Instant now) {
    for (Client& client : clients_) {
        if (client.arrived_at <= now) {
            client.arrived_at = never;
            client.session->receive(std::exchange(client.arrived, {}), now);
        }
    }
}

void SocketcandBus::write_client(Client& client) {
    const std::string& text = client.session->output();
    if (!text.empty()) {
        // when the connection is broken, the client receives nothing more
        client.session->sent(send_some(client.socket, text).value_or(text.size()));
    }
    if (client.leaves() && text.empty()) {
        shutdown(client.socket.number(),
                 SHUT_WR);  // the client can still read the reason; then it closes the connection
    }
    if (client.session->is_dropped()) {
        notice(fmt::format("{} was dropped: {}", client.name, client.session->dropped_because()));
        client.gone = true;
    }
    const Gateway& gateway = client.session->gateway();
    // the client's earlier text was handled before the end of its input was read
    const bool all_sent = gateway.next_frame() == nullptr && !bus_.is_sending(gateway);
    client.gone = client.gone || (client.ended && all_sent);
}

void SocketcandBus::drop_gone_clients() {
    for (Client& client : clients_) {
        if (client.gone) {
            bus_.detach_gateway(client.session->gateway());
            refusal_told_ = refusal_told_ && client.leaves();
        }
    }
    clients_.erase(std::remove_if(clients_.begin(), clients_.end(), [](const Client& client) { return client.gone; }),
                   clients_.end());
}

void SocketcandBus::advance(Instant now) {
    advanced_to_ = now;
    take_arrivals(now);
    bus_.advance(now);
    end_idle_clients(now);
    for (Client& client : clients_) {
        client.session->advance(now);
        client.session->receive({}, now);  // there may be room on the bus now for waiting frames
        write_client(client);
    }
    drop_gone_clients();
}

Instant SocketcandBus::next_deadline() const {
    Instant next = bus_.next_deadline();
    for (const Client& client : clients_) {
        next = earliest(next, earliest(client.arrived_at, client.session->next_deadline()));
        next = earliest(next, client.is_idle() ? client.joined_at + open_limit : client.closes_at);
    }
    return next;
}

}  // namespace canproof::host
