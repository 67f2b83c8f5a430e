// What a client says to a socketcand server, and what it makes of the answers. Knows no socket.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Opens the bus, enters raw mode, then frames go both ways.
class SocketcandClient {
  public:
    /// What the server has not taken yet: beyond this frames must wait.
    static constexpr std::size_t output_limit = 16 * 1024;
    static constexpr std::size_t longest_command = 256;

    using Receiver = std::function<void(const Frame&)>;

    SocketcandClient(std::string bus, Receiver receiver) : bus_{std::move(bus)}, receiver_{std::move(receiver)} {}

    /// What the server sent; pieces of any size.
    void take(std::string_view text);
    bool has_joined() const { return state_ == State::joined; }
    bool may_send() const { return has_joined() && output_.size() < output_limit; }
    /// While may_send(). A remote frame has no form in the protocol.
    void send(const Frame& frame);

    const std::string& output() const { return output_; }
    /// The first `count` characters have reached the server.
    void sent(std::size_t count) { output_.erase(0, count); }
    /// The server's last word of what it does not like; empty when there was none.
    const std::string& complaint() const { return complaint_; }
    /// It would not let the client join.
    bool is_refused() const { return !has_joined() && !complaint_.empty(); }
    std::size_t held() const { return input_.size(); }

  private:
    enum class State { greeting, opening, entering_raw_mode, joined };

    void obey(const std::string& command);
    void go_on();
    void read_frame(const std::string& words);

    std::string bus_;
    Receiver receiver_;
    State state_{State::greeting};
    std::string input_;
    std::string output_;
    std::string complaint_;
};

}  // namespace canproof::host
