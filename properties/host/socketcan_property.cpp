// SPDX-License-Identifier: Apache-2.0
// Compares the SocketCAN bus on a fake kernel with the naive bus of naive_socketcan.hpp, after each step.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <linux/can/error.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "host/sim/bus/socketcan_bus.hpp"
#include "properties/host/naive_socketcan.hpp"
#include "tests/host/sim/bus/bus_bench.hpp"
#include "tests/host/sim/bus/fake_can_system.hpp"

namespace canproof::host {

namespace {

using Naive = NaiveSocketCan;

constexpr std::uint64_t start_us = 1000000;
constexpr std::uint64_t real_ahead_us = 4000000;  // the real-time clock of the fake kernel is 4 s ahead: it shows 5 s
                                                  // at the start of the run (1 s)
constexpr std::size_t port_count = 3;

/// Returns one of a few frames, so that equal frames are frequent. Some differ only in format or remote request.
Frame any_frame() {
    return parse_frame(
        *rc::gen::element<std::string>("703#05", "703#05", "703#06", "00000703#05", "703#R", "703#R1", "080#"), "law");
}

/// The bus on a fake kernel, and the naive bus with its model of the kernel. Both kernels behave alike.
class TwoBuses {
  public:
    TwoBuses(std::uint32_t rate, bool may_control) : naive_{start_us, rate, may_control} {
        system_.rate = rate;
        bus_ = std::make_unique<SocketCanBus>(
            "vcan0", system_, may_control ? InterfaceControl::granted : InterfaceControl::none, Instant{start_us});
        bus_->listen([this](const BusFrame& one) {
            log_.push_back(fmt::format("{} {} {}", one.time.us, one.sender == nullptr ? "-" : one.sender->name(),
                                       format_frame(one.frame)));
        });
        bus_->on_notice([this](const std::string& text) { notices_.push_back(text); });
        bus_->attach(nodes_[0]);
        bus_->attach(nodes_[1]);
    }

    /// Performs one random action, after which some time mostly passes.
    void go_on() {
        const bool is_open = test::FakeCanSystem::is_open(descriptor_of(0));  // nothing arrives at a closed socket
        const auto port = *rc::gen::inRange<std::size_t>(0, port_count);
        const auto node = *rc::gen::inRange<std::size_t>(1, port_count);
        switch (*rc::gen::weightedElement<int>({{is_open ? 8 : 0, 0},
                                                {is_open ? 3 : 0, 2},
                                                {is_open ? 3 : 0, 3},
                                                {is_open ? 2 : 0, 4},
                                                {6, 1},
                                                {2, 5},
                                                {2, 6},
                                                {1, 7},
                                                {1, 8},
                                                {1, 9},
                                                {1, 10}})) {
            case 0:
                arrive(port);
                break;
            case 1:
                send(port, any_frame());
                break;
            case 2:
                answer(port);
                break;
            case 3:
                tell_news(node);
                break;
            case 4:
                fail_read(port);
                break;
            case 5:
                change_interface();
                break;
            case 6:
                come_back();
                break;
            case 7:
                change_rate(node);
                break;
            case 8:
                change_filters(node);
                break;
            case 9:
                naive_.permits_restart = !naive_.permits_restart;
                system_.restart_answer = naive_.permits_restart;
                break;
            default:
                naive_.opens = !naive_.opens;
                system_.open_error = naive_.opens ? 0 : ENODEV;
                break;
        }
        if (*rc::gen::inRange(0, 4) != 0) {
            step(*rc::gen::element<std::uint64_t>(0, 1, 300, 1000, 16000, 100000, 500000, 1000000));
        }
    }
    /// Lets `us` microseconds pass, then compares both buses.
    void step(std::uint64_t us) {
        now_ += us;
        system_.realtime_us = now_ + real_ahead_us;
        bus_->poll(Instant{now_});
        bus_->advance(Instant{now_});
        naive_.step(now_);
        check();
    }

  private:
    int descriptor_of(std::size_t port) const {
        return system_.next_descriptor - static_cast<int>(port_count) + static_cast<int>(port);
    }
    test::FakeCanSystem::Socket& socket_of(std::size_t port) { return system_.sockets[descriptor_of(port)]; }

    void queue(std::size_t port, const can_frame& frame, Naive::Arrival one) {
        one.us = now_ + *rc::gen::element<std::uint64_t>(0, 0, 100, 300, 2000);
        naive_.ports[port].lost_now += *rc::gen::element<std::uint64_t>(0, 0, 0, 1, 5);
        one.dropped = naive_.ports[port].lost_now;
        CanReception got;
        got.frame = frame;
        got.stamp_ns = (one.us + real_ahead_us) * 1000U;
        got.dropped = static_cast<std::uint32_t>(one.dropped);
        socket_of(port).dropped = got.dropped;
        socket_of(port).arriving.push_back({got});
        naive_.ports[port].unread.push_back(one);
    }
    void arrive(std::size_t port) {
        Naive::Arrival one;
        one.frame = any_frame();
        queue(port, to_kernel(one.frame), one);
    }
    void tell_news(std::size_t port) {
        struct News {
            std::uint32_t error_class;
            std::uint8_t controller;
            std::optional<int> state;
            bool overflow;
        };
        // The second number is data[1] of an error frame (linux/can/error.h): 01h and 02h overflow, 04h and 08h
        // warning, 10h and 20h error passive, 40h error active.
        const News news = *rc::gen::elementOf(std::vector<News>{{CAN_ERR_BUSOFF, 0, 3, false},
                                                                {CAN_ERR_BUSOFF, 0, 3, false},
                                                                {CAN_ERR_RESTARTED, 0, 0, false},
                                                                {CAN_ERR_CRTL, 0x08, 1, false},
                                                                {CAN_ERR_CRTL, 0x10, 2, false},
                                                                {CAN_ERR_CRTL, 0x40, 0, false},
                                                                {CAN_ERR_CRTL, 0x01, std::nullopt, true},
                                                                {CAN_ERR_CRTL, 0x22, 2, true},
                                                                {CAN_ERR_PROT, 0x7F, std::nullopt, false}});
        can_frame frame{};
        frame.can_id = CAN_ERR_FLAG | news.error_class;
        frame.can_dlc = 8;
        frame.data[1] = news.controller;
        Naive::Arrival one;
        one.is_news = true;
        one.state = news.state;
        one.overflow = news.overflow;
        queue(port, frame, one);
    }
    void fail_read(std::size_t port) {
        system_.fail(descriptor_of(port), *rc::gen::element(ENETDOWN, ENODEV));
        Naive::Arrival one;
        one.gone = true;
        naive_.ports[port].unread.push_back(one);
    }
    void send(std::size_t port, const Frame& frame) {
        if (port == 0) {
            bus_->put(frame, Instant{now_});
        } else {
            nodes_[port - 1U].waiting.push_back(frame);
        }
        naive_.ports[port].queue.push_back(frame);
    }
    void answer(std::size_t port) {
        const auto [error, answer] =
            *rc::gen::elementOf(std::vector<std::pair<int, Naive::Answer>>{{ENOBUFS, Naive::Answer::full},
                                                                           {ENOBUFS, Naive::Answer::full},
                                                                           {EAGAIN, Naive::Answer::full},
                                                                           {EINVAL, Naive::Answer::invalid},
                                                                           {ENETDOWN, Naive::Answer::gone},
                                                                           {0, Naive::Answer::sent}});
        for (int i = *rc::gen::inRange(1, 7); i > 0; --i) {
            socket_of(port).send_answers.push_back(error);
            naive_.ports[port].answers.push_back(answer);
        }
    }
    void change_interface() {
        naive_.up = false;
        naive_.number = *rc::gen::arbitrary<bool>() ? 0U : naive_.number;
        follow_interface();
    }
    void come_back() {
        naive_.up = true;
        naive_.number = naive_.number == 0 || *rc::gen::arbitrary<bool>() ? ++numbers_ : naive_.number;
        naive_.interface_rate = *rc::gen::element<std::uint32_t>(0, 125000, 500000);
        follow_interface();
    }
    void follow_interface() {
        system_.up = naive_.up;
        system_.number = naive_.number;
        system_.rate = naive_.interface_rate;
    }
    void change_rate(std::size_t node) {
        const auto rate = *rc::gen::element<std::uint32_t>(0, 125000, 250000);
        nodes_[node - 1U].rate = rate;
        naive_.ports[node].rate = rate;
    }
    void change_filters(std::size_t node) {
        nodes_[node - 1U].accepted = {{*rc::gen::element<std::uint32_t>(0x080, 0x703), 0x7FF, false},
                                      {0x703, 0x1FFFFFFF, *rc::gen::arbitrary<bool>()}};
    }

    /// Returns all frames that a port has sent, through all the sockets that it has opened in turn.
    std::vector<std::string> sent_by(std::size_t port) const {
        std::vector<std::string> all;
        for (const auto& [descriptor, socket] : system_.sockets) {
            if (static_cast<std::size_t>(descriptor - 100) % port_count == port) {
                all.insert(all.end(), socket.sent.begin(), socket.sent.end());
            }
        }
        return all;
    }
    void check() {
        RC_ASSERT(log_ == naive_.log);
        for (std::size_t port = 0; port < port_count; ++port) {
            RC_ASSERT(sent_by(port) == naive_.ports[port].sent);
        }
        for (std::size_t port = 1; port < port_count; ++port) {
            RC_ASSERT(nodes_[port - 1U].heard == naive_.ports[port].heard);
            RC_ASSERT(nodes_[port - 1U].states == naive_.ports[port].states);
            RC_ASSERT(nodes_[port - 1U].overruns == naive_.ports[port].overruns);
            check_filters(port);
        }
        RC_ASSERT(bus_->next_deadline() == Instant{naive_.next_deadline()});
        RC_ASSERT(system_.restarts == naive_.restarts);
        RC_ASSERT(system_.rates_set == naive_.rates_set);
        const BusReport report = bus_->report(Instant{now_});
        RC_ASSERT(report.frames == naive_.frames());
        RC_ASSERT(report.errors == naive_.errors);
        RC_ASSERT(report.lost == naive_.lost(false));
        RC_ASSERT(report.missed == naive_.lost(true));
        RC_ASSERT(report.worst_latency.us == naive_.worst_latency);
        RC_ASSERT(report.bit_rate == naive_.bit_rate);
        RC_ASSERT(std::abs(report.load - naive_.load()) < 1.0e-9);
        check_notices();
    }
    /// Checks that each notice contains the words that the naive bus expects.
    void check_notices() {
        RC_ASSERT(notices_.size() == naive_.notices.size());
        for (std::size_t i = 0; i < notices_.size(); ++i) {
            std::string words = naive_.notices[i];
            for (auto space = words.find(' '); !words.empty(); space = words.find(' ')) {
                RC_ASSERT(notices_[i].find(words.substr(0, space)) != std::string::npos);
                words.erase(0, space == std::string::npos ? words.size() : space + 1U);
            }
        }
    }
    /// Checks that the socket of a port, if it is open, has the acceptance filters of the port's node.
    void check_filters(std::size_t port) {
        const test::FakeCanSystem::Socket& socket = socket_of(port);
        const std::vector<AcceptanceFilter>& wanted = nodes_[port - 1U].accepted;
        if (!test::FakeCanSystem::is_open(descriptor_of(port))) {
            return;
        }
        RC_ASSERT(socket.filters.size() == wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            RC_ASSERT(socket.filters[i].can_id == (wanted[i].id | (wanted[i].extended ? CAN_EFF_FLAG : 0U)));
            RC_ASSERT(socket.filters[i].can_mask == (wanted[i].mask | CAN_EFF_FLAG));
        }
    }

    test::FakeCanSystem system_;
    std::array<test::PlainNode, 2> nodes_{test::PlainNode{"a"}, test::PlainNode{"b"}};
    std::unique_ptr<SocketCanBus> bus_;
    Naive naive_;
    unsigned numbers_{3};
    std::uint64_t now_{start_us};
    std::vector<std::string> log_;
    std::vector<std::string> notices_;
};

}  // namespace

RC_GTEST_PROP(SocketCanLaw, BusAgreesWithTheNaiveModelWhateverTheKernelDoes, ()) {
    TwoBuses buses{*rc::gen::element<std::uint32_t>(0, 125000, 500000), *rc::gen::arbitrary<bool>()};
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) {
        buses.go_on();
    }
    buses.step(2000000);
    buses.step(2000000);
}

}  // namespace canproof::host
