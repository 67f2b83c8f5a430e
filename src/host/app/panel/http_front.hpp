// The panel over HTTP on the loopback. No thread: the run loop turns it. No client can keep others waiting: each
// request and each response has its deadline, and the number of connections is bounded.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/http/http_request.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host {

class HttpFront {
  public:
    using Answer = std::function<PanelResponse(const PanelRequest&)>;

    static constexpr std::size_t most_connections = 32;
    /// From when a client has connected until its request is whole.
    static constexpr Duration request_limit = milliseconds(2000);
    /// From then until it has taken the response.
    static constexpr Duration response_limit = milliseconds(5000);
    /// From then until it has closed.
    static constexpr Duration close_limit = milliseconds(1000);

    /// Listens from here on. Port 0: any that is free. Throws InputError when the port cannot be had.
    HttpFront(Answer answer, std::uint16_t port);
    /// Waits for nobody.
    ~HttpFront();
    HttpFront(const HttpFront&) = delete;
    HttpFront& operator=(const HttpFront&) = delete;

    std::vector<Watch> watches() const;
    /// Reads, answers and writes what can be without waiting. `now` never decreases.
    void turn(Instant now);
    Instant next_deadline() const;

    std::uint16_t port() const { return port_; }
    /// `http://127.0.0.1:8404/`
    std::string address() const;
    std::size_t connections() const { return connections_.size(); }

  private:
    struct Connection {
        int descriptor{-1};
        Instant deadline{};
        HttpRequest request;
        std::string output;
        std::size_t written{0};
        bool answered{false};
        bool closing{false};  ///< all is written: what else it sends is passed over until it closes
        bool gone{false};
    };

    void accept_clients(Instant now);
    void make_place();
    void serve(Connection& one, Instant now);
    void read_some(Connection& one);
    void write_some(Connection& one, Instant now);
    void drop_gone();

    Answer answer_;
    int listener_{-1};
    std::uint16_t port_{0};
    std::vector<std::unique_ptr<Connection>> connections_;  ///< in order of arrival
};

}  // namespace canproof::host
