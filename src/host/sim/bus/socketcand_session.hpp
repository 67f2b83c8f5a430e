// SPDX-License-Identifier: Apache-2.0
// One client of the socketcand server, without a socket: it takes text, sends frames to the bus, and produces text.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "host/sim/bus/gateway.hpp"

namespace canproof::host {

/// Handles the commands of python-can, SavvyCAN and socketcand's own client: open, rawmode, bcmmode, controlmode, send,
/// subscribe, unsubscribe, statistics, echo. The protocol has no remote frames, so a client neither receives nor sends
/// them. An unknown command gets the answer `< error … >`.
class SocketcandSession {
  public:
    /// Limit in bytes of text that waits while the bus is busy. With more text, nothing is read from the client.
    static constexpr std::size_t input_limit = 4096;
    /// Greatest length of a command in bytes. A longer command is an error.
    static constexpr std::size_t longest_command = 256;
    /// Limit in bytes of text that the client has not read. With more text, the client is dropped.
    static constexpr std::size_t output_limit = 256 * 1024;
    static constexpr std::size_t gateway_room = 32;
    static constexpr std::size_t most_subscriptions = 256;

    /// Sends the greeting. `epoch_us` is the real time at time 0 of the run, in µs. The client gets real times.
    SocketcandSession(std::string name, std::uint64_t epoch_us);
    SocketcandSession(const SocketcandSession&) = delete;
    SocketcandSession& operator=(const SocketcandSession&) = delete;

    Gateway& gateway() { return gateway_; }
    /// Takes text from the client and executes as many commands as the bus can take now.
    void receive(std::string_view text, Instant now);
    /// Returns whether more text may be read from the client.
    bool wants_input() const { return !is_dropped() && input_.size() < input_limit; }
    /// Sends the statistics that are due.
    void advance(Instant now);
    Instant next_deadline() const { return next_statistics_; }

    const std::string& output() const { return output_; }
    /// Removes the first `count` characters of the output, because they have been sent.
    void sent(std::size_t count) { output_.erase(0, count); }
    /// Returns the reason why the connection must end; empty while it can continue.
    const std::string& dropped_because() const { return dropped_; }
    bool is_dropped() const { return !dropped_.empty(); }

    /// Returns whether the client has opened the bus.
    bool has_joined() const { return mode_ != Mode::no_bus; }
    /// Sends the client the reason why it is dismissed. From then on, ignores text from the client.
    void send_away(const std::string& why);

  private:
    enum class Mode { no_bus, bcm, raw, control };

    void obey(const std::string& command, Instant now);
    void obey_on_bus(const std::string& word, const std::string& rest, Instant now);
    bool change_mode(const std::string& word);
    void send_frame(const std::string& rest);
    void subscribe(const std::string& rest, bool on);
    void set_statistics(const std::string& rest, Instant now);
    void deliver(const Frame& frame, Instant now);
    void say(const std::string& text);

    std::uint64_t epoch_us_;
    Gateway gateway_;
    Mode mode_{Mode::no_bus};
    std::string input_;
    std::string output_;
    std::string dropped_;
    bool sent_away_{false};
    std::set<std::uint64_t> subscriptions_;
    Duration statistics_period_{};
    Instant next_statistics_{never};
    struct Counters {
        std::uint64_t bytes{0};
        std::uint64_t frames{0};
    };
    Counters received_;
    Counters transmitted_;
};

}  // namespace canproof::host
