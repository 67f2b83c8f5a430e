// SPDX-License-Identifier: Apache-2.0
// Compares the bus that is a client of a socketcand server with a naive bus. The test plays the server over the
// loopback interface. Virtual time passes only when the property advances it.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <poll.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "host/sim/bus/socketcand_client_bus.hpp"
#include "properties/host/naive_frame.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/scripted_server.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t user = 2;  ///< the number of the user; nodes a and b have the numbers 0 and 1
constexpr std::uint64_t second = 1000000;

/// A naive bus: nodes a and b and a user share one connection. Of the waiting frames, the one with the lowest
/// arbitration field is sent first. Among equal fields, node a comes first and the user last.
class NaiveClientBus {
  public:
    explicit NaiveClientBus(std::uint64_t rate) : rate_{rate} {}

    void send(std::size_t who, const Frame& frame) { queues_[who].push_back(frame); }
    void arrive(const Frame& frame, std::uint64_t now) { spread(frame, none, now); }
    /// The connection to the server is lost: the nodes are bus-off, and frames of the user wait.
    void lose(std::uint64_t now) {
        is_joined_ = false;
        tell(3, now);
        queues_[0].clear();
        queues_[1].clear();
        said.clear();
    }
    void join_again(std::uint64_t now) {
        is_joined_ = true;
        tell(0, now);
    }
    /// Sends the next frame if the bus is joined and free at `now`.
    void step(std::uint64_t now) {
        const std::size_t who = next();
        if (!is_joined_ || free_from_ > now || who == none) {
            return;
        }
        const Frame frame = queues_[who].front();
        queues_[who].erase(queues_[who].begin());
        const std::uint64_t bits = naive_frame_bits(frame) + 3U;
        free_from_ = now + (bits * second + rate_ - 1U) / rate_;
        if (!frame.remote) {
            std::string text = format_frame(frame);
            said += "< send " + text.substr(0, text.find('#')) + " " + std::to_string(frame.length);
            text.erase(0, text.find('#') + 1U);
            for (; !text.empty(); text.erase(0, 2)) {
                said += " " + text.substr(0, 2);
            }
            said += " >";
        }
        notices += frame.remote && !remote_told_ ? 1U : 0U;
        remote_told_ = remote_told_ || frame.remote;
        spread(frame, who, now);
    }
    std::uint64_t next_deadline() const { return is_joined_ && next() != none ? free_from_ : none; }
    double load(std::uint64_t now) const {
        const double end = static_cast<double>(now) / second;
        const double from = std::max(0.0, end - 1.0);
        double used = 0.0;
        for (const auto& [us, length] : busy_) {
            const double start = static_cast<double>(us) / second;
            used += std::max(0.0, std::min(end, start + length) - std::max(from, start));
        }
        return used / (end - from);
    }
    std::size_t frames() const { return busy_.size(); }

    static constexpr std::uint64_t none = ~std::uint64_t{0};
    std::vector<std::string> log;
    std::array<std::vector<std::string>, 2> heard;
    std::array<std::vector<std::string>, 2> states;
    std::string said;  ///< text that the present connection has sent after it joined the bus
    std::size_t notices{0};

  private:
    std::size_t next() const {
        std::size_t best = none;
        std::string field = "2";
        for (std::size_t who = 0; who < queues_.size(); ++who) {
            if (!queues_[who].empty() && naive_arbitration_field(queues_[who].front()) < field) {
                field = naive_arbitration_field(queues_[who].front());
                best = who;
            }
        }
        return best;
    }
    void spread(const Frame& frame, std::size_t sender, std::uint64_t now) {
        busy_.emplace_back(now, static_cast<double>(naive_frame_bits(frame) + 3U) / static_cast<double>(rate_));
        const std::string name = sender == 0 ? "a" : sender == 1 ? "b" : "-";
        log.push_back(fmt::format("{} {} {}", now, name, format_frame(frame)));
        for (std::size_t node = 0; node < 2; ++node) {
            if (node != sender) {
                heard[node].push_back(fmt::format("{} {}", now, format_frame(frame)));
            }
        }
    }
    void tell(int state, std::uint64_t now) {
        for (std::vector<std::string>& one : states) {
            one.push_back(fmt::format("{} {}", now, state));
        }
        ++notices;
    }

    std::uint64_t rate_;
    bool is_joined_{true};
    bool remote_told_{false};
    std::array<std::vector<Frame>, 3> queues_;
    std::uint64_t free_from_{0};
    std::vector<std::pair<std::uint64_t, double>> busy_;  ///< start and length in seconds of each frame
};

Frame any_frame() {
    Frame frame{};
    const auto number = *rc::gen::element<std::uint32_t>(0x000, 0x010, 0x120, 0x7F0);
    frame.extended = *rc::gen::arbitrary<bool>();
    frame.id = frame.extended && *rc::gen::arbitrary<bool>() ? number << 18U : number;
    frame.remote = *rc::gen::inRange(0, 5) == 0;
    frame.length = *rc::gen::element<std::uint8_t>(0, 1, 8);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        frame.data[i] = *rc::gen::element<std::uint8_t>(0x00, 0x5A, 0xFF);
    }
    return frame;
}

/// The bus with its connection to the server that the test plays, and the naive bus.
class TwoBuses {
  public:
    explicit TwoBuses(std::uint32_t rate) : naive_{rate} {
        bus_ = std::make_unique<SocketcandClientBus>(SocketcandPlace{"127.0.0.1", server_.port(), "vcan0"}, rate,
                                                     Instant{now_});
        bus_->listen([this](const BusFrame& one) {
            log_.push_back(fmt::format("{} {} {}", one.time.us, one.sender == nullptr ? "-" : one.sender->name(),
                                       format_frame(one.frame)));
        });
        bus_->on_notice([this](const std::string&) { ++notices_; });
        bus_->attach(nodes_[0]);
        bus_->attach(nodes_[1]);
        join();
    }
    void go_on() {
        switch (*rc::gen::weightedElement<int>({{10, 0}, {4, 1}, {3, 2}, {8, 3}, {1, 4}})) {
            case 0: {
                const auto node = *rc::gen::inRange<std::size_t>(0, 2);
                const Frame frame = any_frame();
                nodes_[node].waiting.push_back(frame);
                naive_.send(node, frame);
                break;
            }
            case 1: {
                const Frame frame = any_frame();
                bus_->put(frame, Instant{now_});
                naive_.send(user, frame);
                break;
            }
            case 2:
                arrive();
                break;
            case 3:
                pass(*rc::gen::element<std::uint64_t>(0, 1, 40, 300, 1000, 5000));
                break;
            default:
                lose_and_join();
                break;
        }
        RC_ASSERT(bus_->next_deadline() == Instant{naive_.next_deadline()});
    }
    /// Lets `us` microseconds pass and advances both buses at each event.
    void pass(std::uint64_t us) {
        const std::uint64_t end = now_ + us;
        for (std::uint64_t due = now_; due <= end; due = std::max(now_, bus_->next_deadline().us)) {
            now_ = due;
            bus_->advance(Instant{now_});
            naive_.step(now_);
            RC_ASSERT(bus_->next_deadline() > Instant{now_});
        }
        now_ = end;
        bus_->advance(Instant{now_});
        naive_.step(now_);
    }
    void check() {
        RC_ASSERT(log_ == naive_.log);
        for (std::size_t node = 0; node < 2; ++node) {
            RC_ASSERT(nodes_[node].heard == naive_.heard[node]);
            RC_ASSERT(nodes_[node].states == naive_.states[node]);
        }
        RC_ASSERT(server_.heard() == "< open vcan0 >< rawmode >" + naive_.said);
        RC_ASSERT(notices_ == naive_.notices);
        const BusReport report = bus_->report(Instant{now_});
        RC_ASSERT(report.frames == naive_.frames());
        // the bus rounds each frame down to whole nanoseconds
        const double inexact = 1.0e-9 * static_cast<double>(naive_.frames() + 1U);
        RC_ASSERT(std::abs(report.load - naive_.load(now_)) < inexact);
    }

  private:
    static constexpr int longest_wait_ms = 5000;  // reached only if the test fails

    void hear() {
        const std::vector<Watch> watches = bus_->watches();
        RC_ASSERT(watches.size() == 1U);
        pollfd waiting{watches[0].descriptor, static_cast<short>(watches[0].readable ? POLLIN : POLLOUT), 0};
        RC_ASSERT(::poll(&waiting, 1, longest_wait_ms) > 0);
        bus_->poll(Instant{now_});
    }
    void join() {
        server_.accept_one();
        if (bus_->watches().at(0).writable) {
            hear();  // the connection is established
        }
        for (const char* const said : {"< hi >", "< ok >", "< ok >"}) {
            server_.say(said);
            hear();
        }
        RC_ASSERT(bus_->has_joined());
    }
    void arrive() {
        Frame frame = any_frame();
        frame.remote = false;  // the socketcand protocol has no remote frames
        const std::string text = format_frame(frame);
        const auto hash = text.find('#');
        server_.say("< frame " + text.substr(0, hash) + " 1.5 " + text.substr(hash + 1U) + " >");
        hear();
        naive_.arrive(frame, now_);
        bus_->advance(Instant{now_});
        naive_.step(now_);
    }
    /// Loses the server, sometimes in the middle of a message, and joins again. The half message must have no effect on
    /// the new connection.
    void lose_and_join() {
        if (*rc::gen::arbitrary<bool>()) {
            server_.say("< frame 123 1.5 01");
            hear();
        }
        check();
        server_.hang_up();
        hear();
        naive_.lose(now_);
        RC_ASSERT(bus_->watches().empty());
        RC_ASSERT(bus_->next_deadline() == Instant{now_ + second});
        now_ += second;
        bus_->poll(Instant{now_});
        join();
        naive_.join_again(now_);
    }

    test::ScriptedServer server_;
    std::array<test::PlainNode, 2> nodes_{test::PlainNode{"a"}, test::PlainNode{"b"}};
    std::unique_ptr<SocketcandClientBus> bus_;
    NaiveClientBus naive_;
    std::uint64_t now_{second};
    std::vector<std::string> log_;
    std::size_t notices_{0};
};

}  // namespace

RC_GTEST_PROP(SocketcandClientLaw, BusOverASocketcandServerAgreesWithTheNaiveModel, ()) {
    TwoBuses buses{*rc::gen::element<std::uint32_t>(83333, 125000, 1000000)};
    for (int i = *rc::gen::inRange(1, 40); i > 0; --i) {
        buses.go_on();
    }
    buses.pass(500000);
    buses.check();
}

}  // namespace canproof::host
