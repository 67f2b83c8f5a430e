// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcan_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <tuple>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/kernel_frame.hpp"

namespace canproof::host {

namespace {

// number of frames of one socket after which poll() continues with the next socket, so that a busy socket cannot block
// the others
constexpr std::size_t reads_at_once = 4096;
constexpr std::size_t lines_held = 256;

bool is_gone(int error) {
    return error == ENETDOWN || error == ENODEV || error == ENXIO || error == ENOENT;
}

}  // namespace

SocketCanBus::SocketCanBus(std::string interface, CanSystem& system, InterfaceControl control, Instant now)
    : interface_{std::move(interface)}, system_{system}, control_{control} {
    ports_.emplace_back();
    open_socket(ports_.front());
    number_ = system_.interface_number(interface_);
    bit_rate_ = system_.bit_rate(interface_);
    lose_interface(now);  // does nothing when the interface is up
}

void SocketCanBus::attach(BusNode& node) {
    ports_.emplace_back();
    Port& port = ports_.back();
    port.node = &node;
    port.bit_rate = node.bit_rate();
    open_socket(port);
    if (down_) {
        set_state(port, CanState::bus_off, Instant{});
    }
}

bool SocketCanBus::put(const Frame& frame, Instant) {
    std::deque<Frame>& waiting = ports_.front().waiting;
    if (waiting.size() == lines_held) {
        return false;
    }
    waiting.push_back(frame);
    return true;
}

std::vector<Watch> SocketCanBus::watches() const {
    std::vector<Watch> all;
    for (const Port& port : ports_) {
        if (!down_) {
            all.push_back({port.socket.number(), true, false});
        }
    }
    return all;
}

Instant SocketCanBus::poll(Instant now) {
    arrival_clock().compare(now, [this] { return system_.realtime_ns(); });
    if (arrived_.size() >= most_arrived && arrived_.front().time <= known_) {
        return known_;  // the run is behind real time: further frames stay in the kernel, which counts its losses
    }
    known_ = now;
    const auto held = static_cast<std::ptrdiff_t>(arrived_.size());
    for (std::size_t i = 0; i < ports_.size() && !down_; ++i) {
        known_ = earliest(known_, read_socket(i, now));
    }
    // Frames of earlier calls are already sorted. They can be many when the run is behind real time, so only the new
    // frames are sorted in.
    const auto earlier = [](const Arrival& a, const Arrival& b) {
        return std::tie(a.time.us, a.order) < std::tie(b.time.us, b.order);
    };
    const auto news = arrived_.begin() + held;
    std::sort(news, arrived_.end(), earlier);
    if (news != arrived_.end()) {
        std::sort(std::lower_bound(arrived_.begin(), news, *news, earlier), arrived_.end(), earlier);
    }
    return known_;
}

/// Reads a socket. Returns the time up to which its frames are known.
Instant SocketCanBus::read_socket(std::size_t port, Instant now) {
    Port& from = ports_[port];
    Instant last = now;
    for (std::size_t read = 0; read < reads_at_once; read += received_.size()) {
        received_.clear();
        const int error = system_.receive(from.socket.number(), received_);
        for (const CanReception& got : received_) {
            const bool lost = got.dropped != from.dropped;
            count_losses(from, got.dropped);
            last = arrival_time(got.stamp_ns, now);
            arrived_.push_back({last, port, got.frame, lost, arrivals_++});
        }
        if (is_gone(error)) {
            lose_interface(now);
        }
        if (error != 0) {
            return now;
        }
    }
    return last;
}

/// Returns the kernel's time stamp on the run's clock; returns `now` when there is no time stamp. A time before the
/// last call of advance() becomes the time of that call.
Instant SocketCanBus::arrival_time(std::uint64_t stamp_ns, Instant now) {
    const Instant stamped = arrival_clock().at(stamp_ns, now);
    return stamped < advanced_to_ ? advanced_to_ : stamped;
}

void SocketCanBus::advance(Instant now) {
    advanced_to_ = now;
    while (!arrived_.empty() && arrived_.front().time <= now) {
        const Arrival arrival = arrived_.front();
        arrived_.pop_front();
        take(arrival);
        if (ports_[arrival.port].node != nullptr) {
            // The node sends its answer before the next frame of the same time, so that answers do not accumulate in
            // it.
            send_when_due(ports_[arrival.port], now);
        }
    }
    tell_losses(now);
    if (look_at_ <= now) {
        look_for_interface(now);
    }
    if (restart_at_ <= now) {
        restart_controller(now);
    }
    for (Port& port : ports_) {
        if (port.node != nullptr) {
            follow_node(port);
        }
    }
    for (Port& port : ports_) {
        send_when_due(port, now);
    }
}

void SocketCanBus::send_when_due(Port& port, Instant now) {
    if (!down_ && (port.retry == never || port.retry <= now)) {
        send_waiting(port, now);
    }
}

void SocketCanBus::take(const Arrival& arrival) {
    Port& port = ports_[arrival.port];
    if (is_error_frame(arrival.frame)) {
        take_error(port, arrival);
        return;
    }
    const Frame frame = from_kernel(arrival.frame);
    if (port.node == nullptr) {
        count(frame, arrival.time);
        const Sender sender = own_.match(frame, Sender{});
        if (sender.node != nullptr) {
            worst_latency_.us = std::max(worst_latency_.us, elapsed(sender.time, arrival.time).us);
        }
        tell(BusFrame{arrival.time, frame, sender.node});
        return;
    }
    set_overrun(port, arrival.lost_before, arrival.time);
    port.node->receive(frame, arrival.time);
    follow_node(port);  // sets the new filters before the node answers
}

void SocketCanBus::take_error(Port& port, const Arrival& arrival) {
    if (port.node == nullptr || down_) {
        return;  // an interface that is down is already reported as bus-off to the nodes
    }
    const Instant now = arrival.time;
    const ControllerNews news = read_error_frame(arrival.frame);
    // every node gets each error frame, so only those of the first node are counted
    errors_ += &port == &ports_[1] ? 1U : 0U;
    if (news.overrun || arrival.lost_before) {
        set_overrun(port, true, now);
    }
    if (news.state) {
        set_state(port, *news.state, now);
        const bool bus_off = *news.state == CanState::bus_off;
        if (restart_at_ == never) {  // no restart is pending, so a refusal of the next restart is reported again
            restart_failure_told_ = false;
        }
        restart_at_ = bus_off ? now + restart_after : never;
    }
}

void SocketCanBus::set_overrun(Port& port, bool lost, Instant now) {
    if (port.overrun != lost) {
        port.overrun = lost;
        port.node->set_overrun(lost, now);
    }
}

void SocketCanBus::set_state(Port& port, CanState state, Instant now) {
    if (port.reported_state != state) {
        port.reported_state = state;
        port.node->set_can_state(state, now);
    }
}

const Frame* SocketCanBus::next_frame(const Port& port) const {
    return port.node != nullptr ? port.node->next_frame() : port.waiting.empty() ? nullptr : &port.waiting.front();
}

void SocketCanBus::send_waiting(Port& port, Instant now) {
    for (const Frame* next = next_frame(port); next != nullptr; next = next_frame(port)) {
        const Frame frame = *next;
        const int error = system_.send(port.socket.number(), to_kernel(frame));
        if (error == ENOBUFS || error == EAGAIN) {
            port.pause = port.pause.us == 0 ? first_pause : Duration{std::min(port.pause.us * 2, longest_pause.us)};
            port.retry = now + port.pause;
            return;
        }
        if (is_gone(error)) {
            lose_interface(now);
            port.retry = down_ ? never : now + longest_pause;
            return;
        }
        if (error != 0) {
            notice(fmt::format("{} refused the frame {} ({})", interface_, format_frame(frame), std::strerror(error)));
        } else if (port.node != nullptr) {
            own_.sent(frame, Sender{port.node, now});
        }
        if (port.node != nullptr) {
            port.node->take_frame();
        } else {
            port.waiting.pop_front();
        }
        if (port.node == nullptr && error == 0) {
            count(frame, now);  // a socket does not receive its own frames, so they are counted here
            tell(BusFrame{now, frame, nullptr});
        }
        port.pause = Duration{};
    }
    port.retry = never;
}

Instant SocketCanBus::next_deadline() const {
    Instant next = earliest(look_at_, restart_at_);
    if (!arrived_.empty()) {
        next = earliest(next, arrived_.front().time);
    }
    for (const Port& port : ports_) {
        next = earliest(next, port.retry);
    }
    return next;
}

}  // namespace canproof::host
