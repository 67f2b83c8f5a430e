// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcand_session.hpp"

#include <fmt/format.h>

#include <optional>
#include <sstream>
#include <vector>

#include "host/sim/bus/socketcand_text.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t micros = 1000000;
constexpr std::uint64_t longest_period_ms = 3600000;

/// Parses `ID LENGTH BYTE …` in hexadecimal. The blanks between the bytes are optional. Returns nothing for any other
/// text.
std::optional<Frame> read_frame(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    Frame frame{};
    if (words.size() < 2 || !read_identifier(words[0], frame)) {
        return std::nullopt;
    }
    const auto length = hex_number(words[1], max_frame_length);
    std::string bytes;
    for (std::size_t i = 2; i < words.size(); ++i) {
        if (words.size() > 3 && words[i].size() > 2) {  // a single word may contain all bytes
            return std::nullopt;
        }
        bytes += words[i].size() == 1 ? "0" + words[i] : words[i];  // python-can writes 5 in place of 05
    }
    if (!length || bytes.size() != 2U * *length || !read_bytes(bytes, frame)) {
        return std::nullopt;
    }
    return frame;
}

std::uint64_t key_of(const Frame& frame) {
    return (frame.extended ? std::uint64_t{1} << 32U : 0U) | frame.id;
}

}  // namespace

SocketcandSession::SocketcandSession(std::string name, std::uint64_t epoch_us)
    : epoch_us_{epoch_us}, gateway_{std::move(name), gateway_room, [this](const Frame& frame, Instant now) {
                                        deliver(frame, now);
                                    }} {
    say("< hi >");
}

void SocketcandSession::say(const std::string& text) {
    if (output_.size() + text.size() > output_limit) {
        dropped_ = "the client did not read the text that was sent to it";
        return;
    }
    output_ += text;
}

void SocketcandSession::send_away(const std::string& why) {
    say("< error " + why + " >");
    sent_away_ = true;
    input_.clear();
}

void SocketcandSession::receive(std::string_view text, Instant now) {
    if (sent_away_) {
        return;
    }
    input_ += text;
    while (!is_dropped() && !gateway_.is_full()) {
        bool too_long = false;
        const auto command = take_command(input_, longest_command, too_long);
        if (too_long) {
            say("< error command too long >");
            continue;
        }
        if (!command) {
            break;
        }
        obey(*command, now);
    }
}

void SocketcandSession::obey(const std::string& command, Instant now) {
    std::istringstream in{command};
    std::string word;
    in >> word;
    std::string rest;
    std::getline(in, rest);
    if (word == "echo") {
        say("< echo >");
    } else if (word == "open") {
        // There is only one bus, so every name opens it.
        const bool named = !words_of(rest).empty();
        mode_ = named ? Mode::bcm : mode_;
        say(named ? "< ok >" : "< error could not open bus >");
    } else if (mode_ == Mode::no_bus) {
        say("< error no bus is open >");
    } else {
        obey_on_bus(word, rest, now);
    }
}

void SocketcandSession::obey_on_bus(const std::string& word, const std::string& rest, Instant now) {
    if (change_mode(word)) {
        say("< ok >");
    } else if (word == "send" && mode_ != Mode::control) {
        send_frame(rest);
    } else if (word == "subscribe" && mode_ == Mode::bcm) {
        subscribe(rest, true);
    } else if (word == "unsubscribe" && mode_ == Mode::bcm) {
        subscribe(rest, false);
    } else if (word == "statistics") {
        set_statistics(rest, now);
    } else {
        say("< error unknown command >");
    }
}

bool SocketcandSession::change_mode(const std::string& word) {
    const bool known = word == "rawmode" || word == "bcmmode" || word == "controlmode";
    if (known) {
        mode_ = word == "rawmode" ? Mode::raw : word == "bcmmode" ? Mode::bcm : Mode::control;
        subscriptions_.clear();
    }
    return known;
}

void SocketcandSession::send_frame(const std::string& rest) {
    const auto frame = read_frame(rest);
    if (!frame) {
        say("< error send takes identifier, length and bytes in hexadecimal; the protocol has no remote frames >");
        return;
    }
    if (gateway_.put(*frame)) {
        ++transmitted_.frames;
        transmitted_.bytes += frame->length;
    }
}

/// Handles `SECONDS MICROSECONDS ID`, or `ID` to unsubscribe. Ignores the times, which are meant to limit how often a
/// frame is sent: the client gets every frame.
void SocketcandSession::subscribe(const std::string& rest, bool on) {
    const std::vector<std::string> words = words_of(rest);
    Frame frame{};
    const bool sound = words.size() == (on ? 3U : 1U) && read_identifier(words.back(), frame);
    if (!sound || (on && subscriptions_.size() == most_subscriptions)) {
        say("< error subscribe takes seconds, microseconds and an identifier, for up to 256 identifiers; unsubscribe "
            "takes an identifier >");
    } else if (on) {
        subscriptions_.insert(key_of(frame));
    } else {
        subscriptions_.erase(key_of(frame));
    }
}

void SocketcandSession::set_statistics(const std::string& rest, Instant now) {
    const std::vector<std::string> words = words_of(rest);
    const bool number =
        words.size() == 1 && words[0].size() < 9 && words[0].find_first_not_of("0123456789") == std::string::npos;
    if (!number || std::stoull(words[0]) > longest_period_ms) {
        say("< error statistics takes a period in milliseconds, 0 for none >");
        return;
    }
    statistics_period_ = milliseconds(std::stoull(words[0]));
    next_statistics_ = statistics_period_.us == 0 ? never : now + statistics_period_;
}

void SocketcandSession::advance(Instant now) {
    if (next_statistics_ <= now) {
        say(fmt::format("< stat {} {} {} {} >", received_.bytes, received_.frames, transmitted_.bytes,
                        transmitted_.frames));
        next_statistics_ = now + statistics_period_;
    }
}

void SocketcandSession::deliver(const Frame& frame, Instant now) {
    const bool wanted =
        mode_ == Mode::raw || subscriptions_.count(key_of(frame)) != 0;  // subscriptions exist only in mode bcm
    if (mode_ == Mode::no_bus || is_dropped()) {
        return;
    }
    ++received_.frames;
    received_.bytes += frame.length;
    if (!wanted || frame.remote) {
        return;
    }
    const std::uint64_t us = epoch_us_ + now.us;
    std::string text = fmt::format("< frame {} {}.{:06} ", format_identifier(frame), us / micros, us % micros);
    for (std::size_t i = 0; i < frame.length; ++i) {
        text += fmt::format("{:02X}", frame.data[i]);
    }
    say(text + " >");
}

}  // namespace canproof::host
