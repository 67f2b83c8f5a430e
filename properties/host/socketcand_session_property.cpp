// SPDX-License-Identifier: Apache-2.0
// Compares the frames that a socketcand client receives with those that it should receive by a simple list of its
// subscriptions.
#include <fmt/format.h>
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/socketcand_session.hpp"

namespace canproof::host {

namespace {

/// A naive client: its commands, and the frames that it should receive. Identifiers are stored as texts of three digits
/// (11 bits) or eight digits (29 bits).
class NaiveClient {
  public:
    std::string open() {
        mode_ = "bcmmode";
        return "< ok >";
    }
    std::string change_mode(const std::string& mode) {
        if (mode_.empty()) {
            return "< error no bus is open >";
        }
        mode_ = mode;
        wanted_.clear();
        return "< ok >";
    }
    std::string subscribe(const std::string& id, bool on) {
        if (mode_ != "bcmmode") {
            return mode_.empty() ? "< error no bus is open >" : "< error unknown command >";
        }
        wanted_.erase(std::remove(wanted_.begin(), wanted_.end(), id), wanted_.end());
        if (on) {
            wanted_.push_back(id);
        }
        return "";
    }
    std::string send(std::size_t length) {
        if (mode_.empty() || mode_ == "controlmode") {
            return mode_.empty() ? "< error no bus is open >" : "< error unknown command >";
        }
        ++frames_sent;
        bytes_sent += length;
        return "";
    }
    std::string hear(const std::string& id, const Frame& frame, const std::string& bytes, std::uint64_t us) {
        if (mode_.empty()) {
            return "";
        }
        ++frames_heard;
        bytes_heard += frame.length;
        const bool asked = std::find(wanted_.begin(), wanted_.end(), id) != wanted_.end();
        const bool hears = mode_ == "rawmode" || (mode_ == "bcmmode" && asked);
        return hears && !frame.remote
                   ? fmt::format("< frame {} {}.{:06} {} >", id, 1700000000U + us / 1000000U, us % 1000000U, bytes)
                   : "";
    }
    std::string set_statistics(std::uint64_t period_ms, std::uint64_t now) {
        if (mode_.empty()) {
            return "< error no bus is open >";
        }
        period_ = 1000U * period_ms;
        next_ = period_ == 0 ? never_due : now + period_;
        return "";
    }
    /// If statistics are due, returns their text. They count everything since the client opened the bus.
    std::string pass(std::uint64_t now) {
        if (now < next_) {
            return "";
        }
        next_ = now + period_;
        return fmt::format("< stat {} {} {} {} >", bytes_heard, frames_heard, bytes_sent, frames_sent);
    }
    std::uint64_t next_deadline() const { return next_; }
    bool is_open() const { return !mode_.empty(); }

    std::size_t frames_sent{0};
    std::size_t bytes_sent{0};
    std::size_t frames_heard{0};
    std::size_t bytes_heard{0};

  private:
    static constexpr std::uint64_t never_due = ~std::uint64_t{0};
    std::string mode_;
    std::uint64_t period_{0};
    std::uint64_t next_{never_due};
    std::vector<std::string> wanted_;
};

/// Returns one of a few identifiers with 11 or 29 bits, as text.
std::string any_identifier() {
    return *rc::gen::element<std::string>("000", "00000000", "181", "00000181", "7FF", "000007FF", "1FFFFFFF");
}

class Conversation {
  public:
    Conversation() { heard(); }  // reads and drops the greeting of the server
    void go_on() {
        now_ += *rc::gen::inRange<std::uint64_t>(0, 100);
        const std::string id = any_identifier();
        const auto mode = *rc::gen::element<std::string>("rawmode", "bcmmode", "bcmmode", "controlmode");
        std::string expected;
        switch (*rc::gen::weightedElement<int>({{1, 0}, {1, 1}, {4, 2}, {3, 3}, {2, 4}, {6, 5}, {1, 6}, {2, 7}})) {
            case 0:
                expected = naive_.open();
                say("< open can0 >");
                break;
            case 1:
                expected = naive_.change_mode(mode);
                say("< " + mode + " >");
                break;
            case 2:
                expected = naive_.subscribe(id, true);
                say("< subscribe 0 0 " + id + " >");
                break;
            case 3:
                expected = naive_.subscribe(id, false);
                say("< unsubscribe " + id + " >");
                break;
            case 4:
                expected = send(id);
                break;
            case 6:
                expected = set_statistics();
                break;
            case 7:
                expected = pass();
                break;
            default:
                expected = arrive(id);
                break;
        }
        RC_ASSERT(heard() == expected);
        RC_ASSERT(session_.next_deadline() == Instant{naive_.next_deadline()});
    }
    /// Checks the counters of frames and bytes that the server sends to the client.
    void check_counts() {
        if (naive_.is_open()) {
            say("< statistics 1 >");
            session_.advance(Instant{now_ + 1000});
            RC_ASSERT(heard() == fmt::format("< stat {} {} {} {} >", naive_.bytes_heard, naive_.frames_heard,
                                             naive_.bytes_sent, naive_.frames_sent));
        }
    }

  private:
    void say(const std::string& text) { session_.receive(text, Instant{now_}); }
    std::string heard() {
        std::string text = session_.output();
        session_.sent(text.size());
        return text;
    }
    std::string set_statistics() {
        const auto period = *rc::gen::element<std::uint64_t>(0, 1, 500);
        say(fmt::format("< statistics {} >", period));
        return naive_.set_statistics(period, now_);
    }
    std::string pass() {
        now_ += *rc::gen::element<std::uint64_t>(0, 1000, 500000, 800000);
        session_.advance(Instant{now_});
        return naive_.pass(now_);
    }
    std::string send(const std::string& id) {
        const auto length = *rc::gen::inRange<std::size_t>(0, 9);
        std::string bytes;
        for (std::size_t i = 0; i < length; ++i) {
            bytes += fmt::format(" {:02X}", 0x11U * i);
        }
        const std::string expected = naive_.send(length);
        say(fmt::format("< send {} {:X}{} >", id, length, bytes));
        if (expected.empty()) {
            bytes.erase(std::remove(bytes.begin(), bytes.end(), ' '), bytes.end());
            RC_ASSERT(session_.gateway().next_frame() != nullptr);
            RC_ASSERT(format_frame(*session_.gateway().next_frame()) == id + "#" + bytes);
            session_.gateway().take_frame();
        }
        RC_ASSERT(session_.gateway().next_frame() == nullptr);
        return expected;
    }
    std::string arrive(const std::string& id) {
        const bool remote = *rc::gen::inRange(0, 4) == 0;
        const std::string bytes = *rc::gen::element<std::string>("", "05", "0102030405060708");
        const Frame frame = parse_frame(id + "#" + (remote ? "R" : bytes), "law");
        session_.gateway().receive(frame, Instant{now_});
        return naive_.hear(id, frame, bytes, now_);
    }

    SocketcandSession session_{"client", 1700000000000000};
    NaiveClient naive_;
    std::uint64_t now_{0};
};

}  // namespace

RC_GTEST_PROP(SocketcandSessionLaw, ClientReceivesTheFramesThatItSubscribedTo, ()) {
    Conversation conversation;
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) {
        conversation.go_on();
    }
    conversation.check_counts();
}

}  // namespace canproof::host
