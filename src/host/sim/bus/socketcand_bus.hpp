// SPDX-License-Identifier: Apache-2.0
// The in-process bus with a socketcand server. Machines and tools without SocketCAN can join the bus over TCP.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/base/tcp_socket.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/socketcand_session.hpp"

namespace canproof::host {

/// Address at which the server listens. Port 0 selects any free port.
struct ListenAddress {
    std::string host{"127.0.0.1"};
    std::uint16_t port{29536};
};

/// Parses `127.0.0.1:29536`, `[::1]:29536` or `:0`. A missing part gets the default of ListenAddress. Throws InputError
/// for an invalid port. Does not check the host.
ListenAddress parse_listen_address(const std::string& text);

/// A bus with a limited number of clients. A client that does not open the bus in time is dismissed, so that it cannot
/// exclude others. TCP keepalive detects a lost machine. A client for which there is no room gets an error message.
/// A client that has opened the bus may be silent.
class SocketcandBus final : public Bus {
  public:
    static constexpr std::size_t most_clients = 32;
    /// Time after which a client is dismissed if it has not opened the bus.
    static constexpr Duration open_limit = milliseconds(10000);
    /// Time after which a client that has not opened the bus is dismissed if a new client needs its place.
    static constexpr Duration patience = milliseconds(1000);
    /// Time in which a dismissed client can read the reason.
    static constexpr Duration leave_limit = milliseconds(1000);
    /// TCP keepalive: seconds of silence before the first probe. The constants below are the seconds between probes and
    /// the number of probes.
    static constexpr int keepalive_idle = 30;
    static constexpr int keepalive_interval = 10;
    static constexpr int keepalive_questions = 3;

    /// Starts to listen. `epoch_us` is the real time at time 0 of the run, in µs. Throws InputError when the address
    /// cannot be opened.
    SocketcandBus(const ListenAddress& address, std::uint32_t bit_rate, const BusFaultRates& faults,
                  std::uint64_t epoch_us);
    SocketcandBus(const SocketcandBus&) = delete;
    SocketcandBus& operator=(const SocketcandBus&) = delete;

    void attach(BusNode& node) override { bus_.attach(node); }
    bool put(const Frame& frame, Instant now) override { return bus_.put(frame, now); }
    std::vector<Watch> watches() const override;
    Instant poll(Instant now) override;
    void advance(Instant now) override;
    Instant next_deadline() const override;
    BusReport report(Instant now) const override { return bus_.report(now); }
    const std::string& interface() const override { return bus_.interface(); }

    /// Returns the port of the server.
    std::uint16_t port() const { return listener_.port; }
    /// Returns the number of clients, without those that have been dismissed.
    std::size_t clients() const;

  private:
    struct Client {
        Descriptor socket;
        std::string name;
        std::unique_ptr<SocketcandSession> session;
        Instant joined_at{};
        Instant closes_at{never};  ///< time at which the connection of a dismissed client is closed
        std::string arrived;       ///< text that has been read and becomes due at arrived_at
        Instant arrived_at{never};
        bool ended{false};  ///< whether the client sends no more; it is removed when the bus has sent its frames
        bool gone{false};

        bool reads() const { return session->wants_input() && arrived.empty() && !ended; }
        bool leaves() const { return closes_at != never; }
        bool is_idle() const { return !leaves() && !session->has_joined(); }
    };

    void accept_clients(Instant now);
    void take_client(Descriptor socket, Instant now);
    bool make_place(Instant now);
    void send_away(Client& client, const std::string& why, Instant now) const;
    void end_idle_clients(Instant now);
    void read_client(Client& client, Instant now);
    void take_arrivals(Instant now);
    void write_client(Client& client);
    void drop_gone_clients();
    void tell_remote_frame(const Frame& frame);

    ArbitratedBus bus_;
    std::uint64_t epoch_us_;
    Listener listener_;
    std::vector<Client> clients_;
    Instant advanced_to_{};
    bool refusal_told_{false};
    bool remote_frame_told_{false};
};

}  // namespace canproof::host
