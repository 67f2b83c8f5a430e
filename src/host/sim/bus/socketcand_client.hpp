// SPDX-License-Identifier: Apache-2.0
// The client side of the socketcand protocol, without a socket.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// A client of a socketcand server. It opens the bus and selects raw mode; then it sends and receives frames.
class SocketcandClient {
  public:
    /// Limit in bytes of text that the server has not read. With more text, frames must wait.
    static constexpr std::size_t output_limit = 16 * 1024;
    static constexpr std::size_t longest_command = 256;

    using Receiver = std::function<void(const Frame&)>;

    SocketcandClient(std::string bus, Receiver receiver) : bus_{std::move(bus)}, receiver_{std::move(receiver)} {}

    /// Takes text from the server, in pieces of any size, and executes the complete commands.
    void take(std::string_view text);
    bool has_joined() const { return state_ == State::joined; }
    bool may_send() const { return has_joined() && output_.size() < output_limit; }
    /// Sends a frame, which must be a data frame, because the protocol has no remote frames. Must be called only while
    /// may_send() returns true.
    void send(const Frame& frame);

    const std::string& output() const { return output_; }
    /// Removes the first `count` characters of the output, because they have been sent.
    void sent(std::size_t count) { output_.erase(0, count); }
    /// Returns the last error message of the server; empty when there was none.
    const std::string& complaint() const { return complaint_; }
    /// Returns whether the server has refused the client.
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
