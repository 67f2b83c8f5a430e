// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcand_client.hpp"

#include <fmt/format.h>

#include "host/sim/bus/socketcand_text.hpp"

namespace canproof::host {

void SocketcandClient::take(std::string_view text) {
    input_ += text;
    bool too_long = false;
    for (auto command = take_command(input_, longest_command, too_long); command || too_long;
         command = take_command(input_, longest_command, too_long)) {
        if (command) {
            obey(*command);
        }
    }
}

void SocketcandClient::obey(const std::string& command) {
    const auto words = words_of(command);
    const std::string word = words.empty() ? "" : words[0];
    if (word == "hi" && state_ == State::greeting) {
        go_on();
    } else if (word == "ok" && (state_ == State::opening || state_ == State::entering_raw_mode)) {
        go_on();
    } else if (word == "error") {
        const auto first = command.find("error") + std::string{"error"}.size();
        const auto begin = command.find_first_not_of(' ', first);
        complaint_ = begin == std::string::npos ? "error" : command.substr(begin);
        complaint_.erase(complaint_.find_last_not_of(' ') + 1);
    } else if (word == "frame" && has_joined()) {
        read_frame(command);
    }
}

void SocketcandClient::go_on() {
    if (state_ == State::greeting) {
        output_ += fmt::format("< open {} >", bus_);
        state_ = State::opening;
    } else if (state_ == State::opening) {
        output_ += "< rawmode >";
        state_ = State::entering_raw_mode;
    } else {
        state_ = State::joined;
    }
}

/// Parses `frame ID SECONDS BYTES`. There may be blanks between the bytes, as some servers write them.
void SocketcandClient::read_frame(const std::string& text) {
    const auto words = words_of(text);
    Frame frame{};
    if (words.size() < 3 || !read_identifier(words[1], frame)) {
        return;
    }
    std::string bytes;
    for (std::size_t i = 3; i < words.size(); ++i) {
        bytes += words[i];
    }
    if (read_bytes(bytes, frame)) {
        receiver_(frame);
    }
}

void SocketcandClient::send(const Frame& frame) {
    output_ += fmt::format("< send {} {:X}", format_identifier(frame), frame.length);
    for (std::size_t i = 0; i < frame.length; ++i) {
        output_ += fmt::format(" {:02X}", frame.data[i]);
    }
    output_ += " >";
}

}  // namespace canproof::host
