#include "host/bus/socketcand_session.hpp"

#include <fmt/format.h>

#include <optional>
#include <sstream>
#include <vector>

namespace canproof::host {

namespace {

constexpr std::uint64_t micros = 1000000;
constexpr std::size_t extended_digits = 8;  // an identifier written with eight digits has 29 bits
constexpr std::uint64_t longest_period_ms = 3600000;

std::optional<std::uint32_t> hex_number(const std::string& text, std::uint32_t highest) {
    if (text.empty() || text.size() > 8 || text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
        return std::nullopt;
    }
    const auto number = static_cast<std::uint32_t>(std::stoul(text, nullptr, 16));
    return number <= highest ? std::optional{number} : std::nullopt;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in{text};
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    return words;
}

bool read_identifier(const std::string& text, Frame& frame) {
    frame.extended = text.size() == extended_digits;
    const auto id = hex_number(text, frame.extended ? 0x1FFFFFFFU : 0x7FFU);
    frame.id = id.value_or(0U);
    return id.has_value();
}

/// `ID LENGTH BYTE …`, all in hexadecimal; the bytes may stand together.
std::optional<Frame> read_frame(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    Frame frame{};
    if (words.size() < 2 || !read_identifier(words[0], frame)) {
        return std::nullopt;
    }
    const auto length = hex_number(words[1], max_frame_length);
    std::vector<std::string> bytes{words.begin() + 2, words.end()};
    if (length && bytes.size() == 1 && bytes[0].size() == 2U * *length) {
        const std::string together = bytes[0];
        bytes.clear();
        for (std::size_t i = 0; i < together.size(); i += 2) {
            bytes.push_back(together.substr(i, 2));
        }
    }
    if (!length || bytes.size() != *length) {
        return std::nullopt;
    }
    frame.length = static_cast<std::uint8_t>(*length);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const auto byte = hex_number(bytes[i], 0xFFU);
        if (!byte) {
            return std::nullopt;
        }
        frame.data[i] = static_cast<std::uint8_t>(*byte);
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
        dropped_ = "it did not read what it was sent";
        return;
    }
    output_ += text;
}

void SocketcandSession::send_away(const std::string& why) {
    say("< error " + why + " >");
    sent_away_ = true;
    input_.clear();
}

bool SocketcandSession::receive(std::string_view text, Instant now) {
    if (sent_away_) {
        return false;
    }
    input_ += text;
    const std::uint64_t before = transmitted_.frames;
    while (!is_dropped() && !gateway_.is_full()) {
        const auto begin = input_.find('<');
        input_.erase(0, begin);  // npos: all of it
        const auto end = input_.find('>');
        if (end == std::string::npos || end > longest_command) {
            if (input_.size() <= longest_command) {
                break;
            }
            say("< error command too long >");
            input_.erase(0, longest_command);
            continue;
        }
        const std::string command = input_.substr(1, end - 1);
        input_.erase(0, end + 1);
        obey(command, now);
    }
    return transmitted_.frames != before;
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
        // There is one bus, by whatever name a client is set up for.
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

/// `SECONDS MICROSECONDS ID`: the least time between two frames is not kept, every frame is sent.
void SocketcandSession::subscribe(const std::string& rest, bool on) {
    const std::vector<std::string> words = words_of(rest);
    Frame frame{};
    const bool sound = words.size() == (on ? 3U : 1U) && read_identifier(words.back(), frame);
    if (!sound || (on && subscriptions_.size() == most_subscriptions)) {
        say("< error subscribe takes seconds, microseconds and an identifier >");
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
    const bool wanted = mode_ == Mode::raw || (mode_ == Mode::bcm && subscriptions_.count(key_of(frame)) != 0);
    if (mode_ == Mode::no_bus || is_dropped()) {
        return;
    }
    ++received_.frames;
    received_.bytes += frame.length;
    if (!wanted || frame.remote) {
        return;
    }
    const std::uint64_t us = epoch_us_ + now.us;
    std::string text =
        frame.extended ? fmt::format("< frame {:08X} ", frame.id) : fmt::format("< frame {:03X} ", frame.id);
    text += fmt::format("{}.{:06} ", us / micros, us % micros);
    for (std::size_t i = 0; i < frame.length; ++i) {
        text += fmt::format("{:02X}", frame.data[i]);
    }
    say(text + " >");
}

}  // namespace canproof::host
