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

constexpr std::size_t reads_at_once = 4096;  // a socket, in one turn: a flood on one cannot starve the others
constexpr std::size_t lines_held = 256;
constexpr Duration clock_tolerance = milliseconds(50);  // beyond that somebody has set the clock
constexpr Duration load_window = milliseconds(1000);
constexpr Duration losses_period = milliseconds(1000);

std::string remedy(const std::string& interface, int error) {
    if (error == EAFNOSUPPORT) {
        return "this kernel has no SocketCAN; use --bus socketcand:127.0.0.1:29536 or --bus inproc";
    }
    if (error == ENODEV) {
        return fmt::format("make it with `ip link add dev {0} type vcan; ip link set {0} up`, or name another",
                           interface);
    }
    return "check the interface and your rights";
}

bool is_gone(int error) {
    return error == ENETDOWN || error == ENODEV || error == ENXIO || error == ENOENT;
}

}  // namespace

SocketCanBus::SocketCanBus(std::string interface, CanSystem& system, InterfaceControl control, Instant now)
    : interface_{std::move(interface)}, system_{system}, control_{control} {
    ports_.emplace_back();
    const CanOpening opening = system_.open(interface_, false);
    if (opening.error != 0) {
        throw InputError{fmt::format("{} cannot be opened ({}); {}", interface_, std::strerror(opening.error),
                                     remedy(interface_, opening.error))};
    }
    ports_.front().descriptor = opening.descriptor;
    roomy_ = opening.roomy;
    number_ = system_.interface_number(interface_);
    bit_rate_ = system_.bit_rate(interface_);
    if (!system_.is_up(interface_)) {
        lose_interface(now);
    }
}

SocketCanBus::~SocketCanBus() {
    close_sockets();
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

void SocketCanBus::open_socket(Port& port) {
    const CanOpening opening = system_.open(interface_, port.node != nullptr);
    if (opening.error != 0) {
        throw InputError{fmt::format("{} cannot be opened ({}); {}", interface_, std::strerror(opening.error),
                                     remedy(interface_, opening.error))};
    }
    port.descriptor = opening.descriptor;
    port.dropped = 0;
    roomy_ = roomy_ && opening.roomy;
    if (port.node != nullptr) {
        port.filters = port.node->filters();
        static_cast<void>(system_.set_filters(port.descriptor, kernel_filters(port.filters)));
    }
}

void SocketCanBus::close_sockets() {
    for (Port& port : ports_) {
        if (port.descriptor >= 0) {
            system_.close(port.descriptor);
            port.descriptor = -1;
        }
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
        if (port.descriptor >= 0 && !down_) {
            all.push_back({port.descriptor, true, false});
        }
    }
    return all;
}

Instant SocketCanBus::poll(Instant now) {
    const auto offset = static_cast<std::int64_t>(now.us) - static_cast<std::int64_t>(system_.realtime_ns() / 1000);
    if (!clock_is_known_ || std::abs(offset - clock_offset_us_) > static_cast<std::int64_t>(clock_tolerance.us)) {
        clock_offset_us_ = offset;
        clock_is_known_ = true;
    }
    if (arrived_.size() >= most_arrived && arrived_.front().time <= known_) {
        return known_;  // the run is behind: the rest waits in the kernel, which counts what it cannot hold
    }
    known_ = now;
    const auto held = static_cast<std::ptrdiff_t>(arrived_.size());
    for (std::size_t i = 0; i < ports_.size() && !down_; ++i) {
        known_ = earliest(known_, read_socket(i, now));
    }
    // What was held is in order already: a run that is behind holds much of it, turn after turn.
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

/// Gives the time up to which this socket has been read.
Instant SocketCanBus::read_socket(std::size_t port, Instant now) {
    Port& from = ports_[port];
    Instant last = now;
    for (std::size_t read = 0; read < reads_at_once && from.descriptor >= 0; read += received_.size()) {
        received_.clear();
        const int error = system_.receive(from.descriptor, received_);
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

void SocketCanBus::count_losses(Port& port, std::uint32_t dropped) {
    port.lost += dropped - port.dropped;  // the kernel's count may wrap
    losses_are_news_ = losses_are_news_ || dropped != port.dropped;
    port.dropped = dropped;
}

void SocketCanBus::tell_losses(Instant now) {
    if (!losses_are_news_ || (losses_told_ != never && now < losses_told_ + losses_period)) {
        return;
    }
    losses_are_news_ = false;
    losses_told_ = now;
    for (const Port& port : ports_) {
        if (port.lost != 0) {
            notice(fmt::format("{}: {} frames came faster than they were read and are lost to {}", interface_,
                               port.lost, port.node == nullptr ? "the log" : port.node->name()));
        }
    }
    if (!roomy_) {
        notice(fmt::format("more of them can wait after `sysctl -w net.core.rmem_max={}`, or with CAP_NET_ADMIN",
                           receive_room));
    }
}

/// The kernel's stamp on the run's clock; one that lies before what was already delivered is due at once.
Instant SocketCanBus::arrival_time(std::uint64_t stamp_ns, Instant now) {
    const std::int64_t us = static_cast<std::int64_t>(stamp_ns / 1000) + clock_offset_us_;
    const Instant stamped = stamp_ns == 0 || us < 0 ? now : Instant{static_cast<std::uint64_t>(us)};
    return stamped < advanced_to_ ? advanced_to_ : stamped;
}

void SocketCanBus::advance(Instant now) {
    advanced_to_ = now;
    while (!arrived_.empty() && arrived_.front().time <= now) {
        const Arrival arrival = arrived_.front();
        arrived_.pop_front();
        take(arrival);
        if (ports_[arrival.port].node != nullptr) {
            // Frames of the same time must not pile up their answers in the node.
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
        take_error(port, arrival.frame, arrival.time);
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
    follow_node(port);  // new filters before the answer to what changed them goes out
}

void SocketCanBus::take_error(Port& port, const can_frame& frame, Instant now) {
    if (port.node == nullptr) {
        return;
    }
    const ControllerNews news = read_error_frame(frame);
    errors_ += &port == &ports_[1] ? 1U : 0U;  // each node hears of it
    if (news.overrun) {
        set_overrun(port, true, now);
    }
    if (news.state) {
        set_state(port, *news.state, now);
        restart_at_ = *news.state == CanState::bus_off ? now + restart_after : never;
    }
}

void SocketCanBus::set_overrun(Port& port, bool lost, Instant now) {
    if (port.overrun != lost) {
        port.overrun = lost;
        port.node->set_overrun(lost, now);
    }
}

void SocketCanBus::set_state(Port& port, CanState state, Instant now) {
    if (port.told != state) {
        port.told = state;
        port.node->set_can_state(state, now);
    }
}

/// Without node-ID or with another configuration a node listens to other frames, at another rate.
void SocketCanBus::follow_node(Port& port) {
    if (port.descriptor >= 0) {
        const std::vector<AcceptanceFilter>& wanted = port.node->filters();
        if (!(wanted == port.filters)) {
            static_cast<void>(system_.set_filters(port.descriptor, kernel_filters(wanted)));
            port.filters = wanted;
        }
    }
    const std::uint32_t rate = port.node->bit_rate();
    if (rate != port.bit_rate) {
        port.bit_rate = rate;
        if (rate != 0) {
            change_bit_rate(port);
        }
    }
}

void SocketCanBus::change_bit_rate(const Port& port) {
    const std::string wish = fmt::format("{}: LSS sets {} bit/s", port.node->name(), port.bit_rate);
    const std::string commands =
        fmt::format("would have done: ip link set {0} down; ip link set {0} type can bitrate {1}; ip link set {0} up",
                    interface_, port.bit_rate);
    if (control_ == InterfaceControl::none) {
        notice(fmt::format("{}; {} was left as it is without --control-interface; {}", wish, interface_, commands));
        return;
    }
    const BitRateOutcome outcome = system_.set_bit_rate(interface_, port.bit_rate);
    if (outcome.done) {
        bit_rate_ = port.bit_rate;
        notice(fmt::format("{}; {} has it now", wish, interface_));
    } else {
        notice(fmt::format("{}; {}; {}", wish, outcome.why, commands));
    }
}

const Frame* SocketCanBus::next_frame(const Port& port) const {
    return port.node != nullptr ? port.node->next_frame() : port.waiting.empty() ? nullptr : &port.waiting.front();
}

void SocketCanBus::send_waiting(Port& port, Instant now) {
    for (const Frame* next = next_frame(port); next != nullptr && port.descriptor >= 0; next = next_frame(port)) {
        const Frame frame = *next;
        const int error = system_.send(port.descriptor, to_kernel(frame));
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
            notice(fmt::format("{} did not take {} ({})", interface_, format_frame(frame), std::strerror(error)));
        } else if (port.node != nullptr) {
            own_.sent(frame, Sender{port.node, now});
        }
        if (port.node != nullptr) {
            port.node->take_frame();
        } else {
            port.waiting.pop_front();
            count(frame, now);  // a socket does not hear itself
            tell(BusFrame{now, frame, nullptr});
        }
        port.pause = Duration{};
        port.retry = never;
    }
    port.retry = never;
}

/// The kernel reports a change of the interface even when it is over: what counts is how things are now.
void SocketCanBus::lose_interface(Instant now) {
    const bool same = system_.interface_number(interface_) == number_;
    if (down_ || (same && system_.is_up(interface_))) {
        return;
    }
    down_ = true;
    look_at_ = now + search_period;
    notice(fmt::format("{} is {}; waiting for it", interface_,
                       system_.interface_number(interface_) == 0 ? "gone" : "down"));
    for (Port& port : ports_) {
        port.retry = never;
        port.pause = Duration{};
        port.waiting.clear();
        if (port.node != nullptr) {
            set_state(port, CanState::bus_off, now);
        }
    }
}

void SocketCanBus::look_for_interface(Instant now) {
    look_at_ = now + search_period;
    const unsigned number = system_.interface_number(interface_);
    if (number == 0 || !system_.is_up(interface_)) {
        return;
    }
    if (number != number_) {
        close_sockets();
        try {
            for (Port& port : ports_) {
                open_socket(port);
            }
        } catch (const InputError&) {
            return;  // gone again: the next look will tell
        }
        number_ = number;
    }
    down_ = false;
    look_at_ = never;
    bit_rate_ = system_.bit_rate(interface_);
    notice(fmt::format("{} is up again", interface_));
    for (Port& port : ports_) {
        if (port.node != nullptr) {
            set_state(port, CanState::error_active, now);
        }
    }
}

void SocketCanBus::restart_controller(Instant now) {
    restart_at_ = never;
    if (control_ == InterfaceControl::none) {
        notice(fmt::format(
            "{0} is bus-off and was left so without --control-interface; would have done: ip link set {0} type can "
            "restart",
            interface_));
    } else if (!system_.restart(interface_)) {
        restart_at_ = now + restart_after;
    }
}

void SocketCanBus::count(const Frame& frame, Instant now) {
    ++frames_;
    if (bit_rate_ != 0) {
        const std::uint64_t us = (std::uint64_t{frame_bits(frame)} + intermission_bits) * 1000000U / bit_rate_;
        busy_.push_back({now, us});
        busy_us_ += us;
    }
    while (!busy_.empty() && busy_.front().end + load_window < now) {
        busy_us_ -= busy_.front().us;
        busy_.pop_front();
    }
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

BusReport SocketCanBus::report(Instant now) const {
    BusReport report;
    std::uint64_t used = 0;
    for (const Busy& one : busy_) {
        used += now <= one.end + load_window ? one.us : 0U;
    }
    report.frames = frames_;
    report.errors = errors_;
    for (const Port& port : ports_) {
        const std::uint32_t dropped = port.descriptor >= 0 ? system_.dropped(port.descriptor) : port.dropped;
        (port.node == nullptr ? report.lost : report.missed) += port.lost + (dropped - port.dropped);
    }
    report.load = static_cast<double>(used) / static_cast<double>(load_window.us);
    report.worst_latency = worst_latency_;
    report.bit_rate = bit_rate_;
    return report;
}

}  // namespace canproof::host
