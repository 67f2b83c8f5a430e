// One client of the socketcand protocol: text in, frames onto the bus, text out. Knows no socket.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "host/sim/bus/gateway.hpp"

namespace canproof::host {

/// The commands that python-can, SavvyCAN and socketcand's own client use: open, rawmode, bcmmode, controlmode, send,
/// subscribe, unsubscribe, statistics, echo. The protocol has no remote frames: a client neither hears nor sends them.
/// What is not understood gets `< error … >`.
class SocketcandSession {
  public:
    /// Unread text that is held while the bus is busy; then the client must wait.
    static constexpr std::size_t input_limit = 4096;
    /// A command that is longer than this is none.
    static constexpr std::size_t longest_command = 256;
    /// A client that leaves so much unread is dropped.
    static constexpr std::size_t output_limit = 256 * 1024;
    static constexpr std::size_t gateway_room = 32;
    static constexpr std::size_t most_subscriptions = 256;

    /// `epoch_us` is added to times that the client sees. Greets at once.
    SocketcandSession(std::string name, std::uint64_t epoch_us);
    SocketcandSession(const SocketcandSession&) = delete;
    SocketcandSession& operator=(const SocketcandSession&) = delete;

    Gateway& gateway() { return gateway_; }
    /// Appends what the client sent and obeys as much of it as the bus takes now. True when a frame went onto the bus.
    bool receive(std::string_view text, Instant now);
    /// Whether more may be read from the client.
    bool wants_input() const { return !is_dropped() && input_.size() < input_limit; }
    /// Sends the statistics that are due.
    void advance(Instant now);
    Instant next_deadline() const { return next_statistics_; }

    const std::string& output() const { return output_; }
    /// The first `count` characters have reached the client.
    void sent(std::size_t count) { output_.erase(0, count); }
    /// Why the connection must end; empty while it may last.
    const std::string& dropped_because() const { return dropped_; }
    bool is_dropped() const { return !dropped_.empty(); }

    /// Whether it has opened the bus.
    bool has_joined() const { return mode_ != Mode::no_bus; }
    /// Tells the client why it must go. From then on nothing that it sends counts.
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
