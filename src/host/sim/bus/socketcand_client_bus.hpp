// SPDX-License-Identifier: Apache-2.0
// A bus on the socketcand server of another program. All devices together are one client of this server.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "host/base/tcp_socket.hpp"
#include "host/sim/bus/bus.hpp"
#include "host/sim/bus/bus_load.hpp"
#include "host/sim/bus/socketcand_client.hpp"

namespace canproof::host {

/// The address of a server and the name of its bus.
struct SocketcandPlace {
    std::string host{"127.0.0.1"};
    std::uint16_t port{29536};
    std::string bus{"can0"};
};

/// Parses `HOST:PORT/BUS`, `[::1]:29536` or `:29536`. A missing part gets the default of SocketcandPlace. Throws
/// InputError for an invalid port or name of a bus. Does not check the host.
SocketcandPlace parse_socketcand_place(const std::string& text);

/// A bus behind a socketcand server. The server does not return the client's own frames, so this bus passes the frames
/// of each device to the others. It spaces frames according to the bit rate. Frames wait until the server has accepted
/// the client. When the connection is lost, the devices become bus-off and the bus tries to connect again.
class SocketcandClientBus final : public Bus {
  public:
    /// Time in which a server must accept the client.
    static constexpr Duration join_limit = milliseconds(5000);
    static constexpr Duration search_period = milliseconds(1000);
    /// Approximate number of frames that the bus keeps when the run is behind real time. With more frames, it does not
    /// read from the server.
    static constexpr std::size_t most_arrived = 65536;

    /// Starts to connect and does not wait. Throws InputError when the host does not exist. If the first attempt to
    /// join fails later, poll() or advance() throws InputError.
    SocketcandClientBus(SocketcandPlace place, std::uint32_t bit_rate, Instant now);
    SocketcandClientBus(const SocketcandClientBus&) = delete;
    SocketcandClientBus& operator=(const SocketcandClientBus&) = delete;

    void attach(BusNode& node) override { nodes_.push_back({&node, node.bit_rate()}); }
    bool put(const Frame& frame, Instant now) override;
    std::vector<Watch> watches() const override;
    Instant poll(Instant now) override;
    void advance(Instant now) override;
    Instant next_deadline() const override;
    BusReport report(Instant now) const override;
    const std::string& interface() const override { return place_.bus; }

    bool has_joined() const { return client_ && client_->has_joined(); }

  private:
    struct Node {
        BusNode* node{nullptr};
        std::uint32_t bit_rate{0};
    };
    struct Arrival {
        Instant time{};
        Frame frame{};
    };

    void connect_to_server(Instant now);
    void finish_connecting();
    void read_server(Instant now);
    void write_server();
    void lose_server(const std::string& why, Instant now);
    void look_at_joining(Instant now);
    void tell_state(CanState state, Instant now);
    BusNode* next_sender() const;
    bool any_frame_waits() const { return next_sender() != nullptr || !outside_.empty(); }
    void send_one(Instant now);
    void deliver(const Frame& frame, const BusNode* sender, Instant now);
    void follow_bit_rates();

    SocketcandPlace place_;
    std::uint32_t bit_rate_;
    SocketAddress address_;
    Descriptor socket_;
    bool connecting_{false};
    std::optional<SocketcandClient> client_;
    bool joined_once_{false};
    Instant join_by_{never};
    Instant look_at_{never};  ///< time of the next attempt to reach a lost server
    Instant polled_at_{};
    Instant advanced_to_{};
    Instant read_at_{};  ///< time of arrival of the text that the client processes
    std::vector<Node> nodes_;
    std::deque<Frame> outside_;
    std::deque<Arrival> arrived_;
    Instant may_send_from_{};
    BusLoad load_;
    std::uint64_t frames_{0};
    bool remote_frame_told_{false};
    std::string complaint_told_;  ///< last error message of the server that was reported to the user
};

}  // namespace canproof::host
