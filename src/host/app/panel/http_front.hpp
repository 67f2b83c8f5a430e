// SPDX-License-Identifier: Apache-2.0
// The panel over HTTP on the loopback address. It has no thread: the run loop calls it. No client can block another,
// because each request and each response has a deadline and the number of connections is bounded.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/base/tcp_socket.hpp"
#include "host/http/http_request.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host {

class HttpFront {
  public:
    using Answer = std::function<PanelResponse(const PanelRequest&)>;

    static constexpr std::size_t most_connections = 32;
    /// Longest time from the connection of a client until its request is complete.
    static constexpr Duration request_limit = milliseconds(2000);
    /// Longest time from the complete request until the response is sent.
    static constexpr Duration response_limit = milliseconds(5000);
    /// Longest time from the sent response until the client has closed the connection.
    static constexpr Duration close_limit = milliseconds(1000);

    /// Starts to listen. Port 0 selects any free port. Throws InputError when the port cannot be opened.
    HttpFront(Answer answer, std::uint16_t port);
    HttpFront(const HttpFront&) = delete;
    HttpFront& operator=(const HttpFront&) = delete;

    std::vector<Watch> watches() const;
    /// Accepts clients. Then reads or writes on each connection as much as is possible without waiting, and answers
    /// each complete request. `now` must not be earlier than in the last call.
    void turn(Instant now);
    Instant next_deadline() const;

    std::uint16_t port() const { return listener_.port; }
    /// Returns the address of the page, such as `http://127.0.0.1:8404/`.
    std::string address() const;
    std::size_t connections() const { return connections_.size(); }

  private:
    struct Connection {
        Descriptor socket;
        Instant deadline{};
        HttpRequest request;
        std::string output;
        std::size_t written{0};
        bool answered{false};
        bool closing{false};  ///< the response is sent; further input is discarded until the client closes
        bool gone{false};
    };

    void accept_clients(Instant now);
    void make_place();
    void serve(Connection& one, Instant now);
    void read_some(Connection& one);
    void write_some(Connection& one, Instant now);
    void drop_gone();

    Answer answer_;
    Listener listener_;
    std::vector<std::unique_ptr<Connection>> connections_;  ///< in order of arrival
};

}  // namespace canproof::host
