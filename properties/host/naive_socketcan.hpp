// SPDX-License-Identifier: Apache-2.0
// A naive SocketCAN bus: it keeps lists of all events and searches these lists. It also models the kernel:
// the state of the interface, the answer to each call, and what has arrived at each socket.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host {

class NaiveSocketCan {
  public:
    enum class Answer { sent, full, gone, invalid };
    /// Something that is read from a socket: a frame, an error frame with news of the CAN controller, or an error of
    /// the read.
    struct Arrival {
        std::uint64_t us{0};  ///< time in the run, in us
        Frame frame{};
        bool is_news{false};       ///< whether it is an error frame with news of the CAN controller
        std::optional<int> state;  ///< new state of the CAN controller: 0 error active, 1 warning, 2 error passive, 3
                                   ///< bus-off
        bool overflow{false};      ///< whether the CAN controller has lost a frame
        bool gone{false};          ///< the read fails because the interface is gone
        std::uint64_t dropped{0};  ///< number of frames that the socket has lost so far
        bool after_loss{false};    ///< whether the socket has lost a frame since the previous arrival
        std::size_t port{0};
    };
    struct Port {
        std::vector<Frame> queue;
        std::vector<std::string> heard;
        std::vector<std::string> states;
        std::vector<bool> overruns;
        std::vector<std::string> sent;
        std::vector<Arrival> unread;
        std::vector<Answer> answers;
        int state{0};
        bool overrun{false};
        std::uint64_t retry{none};
        std::uint64_t pause{0};
        std::uint32_t rate{0};
        std::uint32_t rate_known{0};
        std::uint64_t lost_before{0};  ///< frames that earlier sockets of the port have lost
        std::uint64_t lost_read{0};    ///< frames that the present socket has lost, as the last frame that was read
                                       ///< reports
        std::uint64_t lost_now{0};     ///< frames that the present socket has lost, as the kernel counts
    };
    static constexpr std::uint64_t none = ~std::uint64_t{0};

    NaiveSocketCan(std::uint64_t now, std::uint32_t rate, bool may_control)
        : interface_rate{rate}, bit_rate{rate}, may_control_{may_control}, now_{now} {}

    /// Reads all sockets, then performs everything that is due at `now`.
    void step(std::uint64_t now) {
        for (std::size_t i = 0; i < ports.size(); ++i) {
            read(i, now);
        }
        now_ = now;
        act();
    }
    std::uint64_t next_deadline() const {
        std::uint64_t next = std::min(search_, restart_);
        for (const Arrival& one : arrived_) {
            next = std::min(next, one.us);
        }
        for (const Port& one : ports) {
            next = std::min(next, one.retry);
        }
        return next;
    }
    double load() const {
        const double now = static_cast<double>(now_) / second;
        const double from = std::max(0.0, now - 1.0);
        double used = 0.0;
        for (const auto& [us, length] : counted_) {
            const double end = static_cast<double>(us) / second;
            used += std::max(0.0, end - std::max(from, end - length));
        }
        return used / (now - from);
    }
    std::uint64_t lost(bool of_nodes) const {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < ports.size(); ++i) {
            sum += (i != 0) == of_nodes ? ports[i].lost_before + ports[i].lost_now : 0U;
        }
        return sum;
    }
    std::size_t frames() const { return counted_.size(); }

    /// Port 0 is that of the user; ports 1 and 2 are those of nodes a and b.
    std::array<Port, 3> ports;
    std::vector<std::string> log;
    std::vector<std::string> notices;
    std::vector<std::uint32_t> rates_set;
    std::uint64_t errors{0};
    std::uint64_t worst_latency{0};
    int restarts{0};
    // the kernel
    bool up{true};
    unsigned number{3};
    bool opens{true};  ///< whether sockets can be opened
    bool permits_restart{true};
    std::uint32_t interface_rate{0};  ///< bit rate that the kernel reports for the interface
    std::uint32_t bit_rate{0};        ///< bit rate that canproof assumes for the bus

  private:
    static constexpr std::uint64_t second = 1000000;
    static constexpr std::array<const char*, 3> names{"-", "a", "b"};

    void read(std::size_t number_of_port, std::uint64_t now) {
        std::vector<Arrival>& unread = ports[number_of_port].unread;
        while (!is_down_ && !unread.empty()) {
            Arrival one = unread.front();
            unread.erase(unread.begin());
            if (one.gone) {
                lose(now);
                return;  // further frames are read at the next call
            }
            Port& port = ports[number_of_port];
            one.us = std::max(one.us, now_);
            one.port = number_of_port;
            one.after_loss = one.dropped != port.lost_read;
            news_ = news_ || one.after_loss;
            port.lost_read = one.dropped;
            arrived_.push_back(one);
        }
    }

    void act() {
        while (true) {
            const auto first = std::min_element(arrived_.begin(), arrived_.end(),
                                                [](const Arrival& x, const Arrival& y) { return x.us < y.us; });
            if (first == arrived_.end() || first->us > now_) {
                break;
            }
            const Arrival one = *first;
            arrived_.erase(first);
            take(one);
        }
        tell_losses();
        if (search_ <= now_) {
            search();
        }
        if (restart_ <= now_) {
            restart();
        }
        follow(1);
        follow(2);
        for (std::size_t i = 0; i < ports.size(); ++i) {
            send(i);
        }
    }

    void take(const Arrival& one) {
        Port& port = ports[one.port];
        if (one.is_news) {
            take_news(one, port);
            return;
        }
        if (one.port == 0) {
            take_echo(one);
            return;
        }
        set_overrun(port, one.after_loss);
        port.heard.push_back(fmt::format("{} {}", one.us, format_frame(one.frame)));
        follow(one.port);
        send(one.port);
    }
    void take_news(const Arrival& one, Port& port) {
        if (!is_down_) {
            errors += one.port == 1 ? 1U : 0U;
            if (one.overflow || one.after_loss) {
                set_overrun(port, true);
            }
            if (one.state) {
                set_state(port, *one.state, one.us);
                refusal_told_ = refusal_told_ && restart_ != none;
                restart_ = *one.state == 3 ? one.us + 500000U : none;
            }
        }
        send(one.port);
    }
    static void set_overrun(Port& port, bool lost) {
        if (lost != port.overrun) {
            port.overruns.push_back(lost);
            port.overrun = lost;
        }
    }
    void take_echo(const Arrival& one) {
        std::string sender = names[0];
        for (auto own = own_.begin(); own != own_.end(); ++own) {
            if (format_frame(own->frame) == format_frame(one.frame)) {
                sender = names[own->port];
                worst_latency = std::max(worst_latency, one.us > own->us ? one.us - own->us : 0U);
                own_.erase(own);
                break;
            }
        }
        count(one.frame, one.us);
        log.push_back(fmt::format("{} {} {}", one.us, sender, format_frame(one.frame)));
    }
    void count(const Frame& frame, std::uint64_t us) {
        const double bits = frame_bits(frame) + 3U;
        counted_.emplace_back(us, bit_rate == 0 ? 0.0 : bits / bit_rate);
    }

    void set_state(Port& port, int state, std::uint64_t us) {
        if (state != port.state) {
            port.state = state;
            port.states.push_back(fmt::format("{} {}", us, state));
            if (state == 3) {
                port.queue.clear();
            }
        }
    }

    void tell_losses() {
        if (!news_ || (told_ != none && now_ < told_ + second)) {
            return;
        }
        news_ = false;
        told_ = now_;
        for (std::size_t i = 0; i < ports.size(); ++i) {
            const std::uint64_t lost = ports[i].lost_before + ports[i].lost_read;
            if (lost != 0) {
                notices.push_back(fmt::format("{} lost for {}", lost, i == 0 ? "the log" : names[i]));
            }
        }
    }

    void send(std::size_t number_of_port) {
        Port& port = ports[number_of_port];
        if (is_down_ || (port.retry != none && port.retry > now_)) {
            return;
        }
        port.retry = none;
        while (!port.queue.empty()) {
            const Frame frame = port.queue.front();
            Answer answer = up ? Answer::sent : Answer::gone;
            if (!port.answers.empty()) {
                answer = port.answers.front();
                port.answers.erase(port.answers.begin());
            }
            if (answer == Answer::full) {
                port.pause = port.pause == 0 ? 1000U : std::min<std::uint64_t>(2U * port.pause, 16000U);
                port.retry = now_ + port.pause;
                return;
            }
            if (answer == Answer::gone) {
                lose(now_);
                port.retry = is_down_ ? none : now_ + 16000U;
                return;
            }
            port.queue.erase(port.queue.begin());
            port.pause = 0;
            if (answer == Answer::invalid) {
                notices.push_back("refused " + format_frame(frame));
                continue;
            }
            port.sent.push_back(format_frame(frame));
            if (number_of_port == 0) {
                count(frame, now_);
                log.push_back(fmt::format("{} - {}", now_, format_frame(frame)));
            } else {
                own_.push_back({now_, frame, number_of_port});
            }
        }
    }

    void follow(std::size_t number_of_port) {
        Port& port = ports[number_of_port];
        if (port.rate == port.rate_known) {
            return;
        }
        port.rate_known = port.rate;
        if (port.rate == 0) {
            return;
        }
        notices.push_back(fmt::format("{} {}", names[number_of_port], port.rate));
        if (may_control_) {
            rates_set.push_back(port.rate);
            bit_rate = port.rate;
        }
    }

    void lose(std::uint64_t now) {
        if (up && number == known_number_) {
            return;
        }
        is_down_ = true;
        restart_ = none;
        search_ = now + 100000U;
        notices.emplace_back(number == 0 ? "gone" : "down");
        for (std::size_t i = 0; i < ports.size(); ++i) {
            ports[i].retry = none;
            ports[i].pause = 0;
            if (i != 0) {
                set_state(ports[i], 3, now);
            }
        }
        ports[0].queue.clear();
    }
    void search() {
        search_ = now_ + 100000U;
        if (number == 0 || !up) {
            return;
        }
        if (number != known_number_) {
            close();
            if (!opens) {
                return;
            }
            known_number_ = number;
            own_.clear();
        }
        is_down_ = false;
        search_ = none;
        bit_rate = interface_rate;
        notices.emplace_back("up again");
        set_state(ports[1], 0, now_);
        set_state(ports[2], 0, now_);
    }
    /// The sockets are closed. Frames that were not read from them are lost.
    void close() {
        for (Port& one : ports) {
            one.unread.clear();
            one.answers.clear();
            one.lost_before += one.lost_read;
            one.lost_read = one.lost_now = 0;
        }
    }
    void restart() {
        restart_ = none;
        if (!may_control_) {
            notices.emplace_back("stays bus-off");
            return;
        }
        ++restarts;
        if (!permits_restart) {
            restart_ = now_ + 500000U;
            if (!refusal_told_) {
                notices.emplace_back("refuses the restart");
            }
            refusal_told_ = true;
        }
    }

    struct Own {
        std::uint64_t us;
        Frame frame;
        std::size_t port;
    };
    bool may_control_;
    std::uint64_t now_;
    bool is_down_{false};
    unsigned known_number_{3};
    std::uint64_t search_{none};
    std::uint64_t restart_{none};
    bool refusal_told_{false};
    bool news_{false};
    std::uint64_t told_{none};
    std::vector<Arrival> arrived_;  ///< in the order of reading
    std::vector<Own> own_;
    std::vector<std::pair<std::uint64_t, double>> counted_;  ///< end and length in seconds of each frame
};

}  // namespace canproof::host
