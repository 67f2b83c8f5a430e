#include "host/sim/bus/arbitrated_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/can_bits.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t ns_per_us = 1000;
constexpr std::uint64_t ns_per_s = 1000000000;
constexpr std::size_t lines_held = 256;  // frames that put() keeps while the bus is busy

/// The first whole microsecond at which it has happened.
Instant instant_of(std::uint64_t ns) {
    return Instant{(ns + ns_per_us - 1) / ns_per_us};
}

}  // namespace

ArbitratedBus::ArbitratedBus(std::string interface, std::uint32_t bit_rate, const BusFaultRates& faults)
    : interface_{std::move(interface)},
      bit_rate_{bit_rate == 0 ? 125000 : bit_rate},
      faults_{faults},
      outside_{"outside", lines_held, {}} {
    add_port(outside_, true);
}

ArbitratedBus::Port& ArbitratedBus::add_port(BusNode& node, bool gateway) {
    ports_.push_back(std::make_unique<Port>());
    ports_.back()->node = &node;
    ports_.back()->gateway = gateway;
    return *ports_.back();
}

void ArbitratedBus::attach(BusNode& node) {
    const auto nodes = std::count_if(ports_.begin(), ports_.end(), [](const auto& port) { return !port->gateway; });
    if (static_cast<std::size_t>(nodes) == most_nodes) {
        throw InputError{fmt::format("{} is one node too many; a CANopen bus has at most {}", node.name(), most_nodes)};
    }
    add_port(node, false);
}

void ArbitratedBus::attach_gateway(Gateway& gateway) {
    add_port(gateway, true);
}

void ArbitratedBus::detach_gateway(const Gateway& gateway) {
    const auto found =
        std::find_if(ports_.begin(), ports_.end(), [&](const auto& port) { return port->node == &gateway; });
    if (found == ports_.end()) {
        return;
    }
    const auto at = static_cast<std::size_t>(found - ports_.begin());
    if (running_ && running_->port == at) {
        break_off(advanced_to_);
    }
    if (running_ && running_->port > at) {
        --running_->port;
    }
    ports_.erase(found);
}

bool ArbitratedBus::is_sending(const Gateway& gateway) const {
    for (std::size_t i = 0; i < ports_.size(); ++i) {
        if (ports_[i]->node == &gateway) {
            return ports_[i]->repeated.has_value() || (running_ && running_->port == i);
        }
    }
    return false;
}

bool ArbitratedBus::put(const Frame& frame, Instant) {
    return outside_.put(frame);
}

ArbitratedBus::Nanoseconds ArbitratedBus::bits(unsigned count) const {
    return (count * ns_per_s + bit_rate_ / 2) / bit_rate_;
}

bool ArbitratedBus::takes_part(const Port& port) const {
    const std::uint32_t rate = port.node->bit_rate();
    return port.counters.state() != CanState::bus_off && (rate == 0 || rate == bit_rate_);
}

void ArbitratedBus::follow_bit_rates() {
    std::map<std::uint32_t, std::size_t> votes;
    for (const auto& port : ports_) {
        if (!port->gateway && port->node->bit_rate() != 0) {
            ++votes[port->node->bit_rate()];
        }
    }
    for (const auto& [rate, count] : votes) {
        const auto own = votes.find(bit_rate_);
        if (own == votes.end() || count > own->second) {
            bit_rate_ = rate;
        }
    }
    tell_bit_rates();
}

void ArbitratedBus::tell_bit_rates() {
    for (auto& port : ports_) {
        const std::uint32_t before = port->rate;
        port->rate = port->gateway ? 0 : port->node->bit_rate();
        if (before != 0 && port->rate != before) {
            const char* const outcome =
                port->rate == bit_rate_ ? "the bus has it now" : "it hears and is heard by no other";
            notice(fmt::format("{}: LSS sets {} bit/s; {}", port->node->name(), port->rate, outcome));
        }
    }
}

void ArbitratedBus::advance(Instant now) {
    const Nanoseconds at = now.us * ns_per_us;
    advanced_to_ = at;
    bool any = true;
    while (any) {
        if (!running_) {
            follow_bit_rates();
        }
        recover(at);
        note_waiting(at);
        any = complete(at) || start(at);
    }
    while (!busy_.empty() && busy_.front().end + ns_per_s < at) {
        busy_.pop_front();
    }
}

void ArbitratedBus::note_waiting(Nanoseconds now) {
    for (std::size_t i = 0; i < ports_.size(); ++i) {
        Port& port = *ports_[i];
        if (running_ && running_->port == i) {
            continue;  // the frame on the wire is its first one still
        }
        const bool waits = port.next() != nullptr;
        if (waits && !port.waits) {
            port.first_since = now;
        }
        port.waits = waits;
    }
}

ArbitratedBus::Port* ArbitratedBus::winner(Nanoseconds at) {
    Port* best = nullptr;
    for (auto& port : ports_) {
        if (port->waits && takes_part(*port) && port->may_send_from <= at &&
            (best == nullptr || arbitration_rank(*port->next()) < arbitration_rank(*best->next()))) {
            best = port.get();
        }
    }
    return best;
}

/// Frames that waited for the bus start at once when it falls idle, in the middle of a microsecond if need be.
bool ArbitratedBus::start(Nanoseconds now) {
    if (running_) {
        return false;
    }
    Nanoseconds at = idle_from_ + ns_per_us > now ? idle_from_ : now;
    if (at > now) {
        return false;
    }
    Port* port = winner(at);
    if (port == nullptr) {
        at = now;
        port = winner(at);
    }
    if (port == nullptr) {
        return false;
    }
    Transmission next;
    next.port = static_cast<std::size_t>(
        std::find_if(ports_.begin(), ports_.end(), [&](const auto& one) { return one.get() == port; }) -
        ports_.begin());
    next.frame = *port->next();
    if (port->repeated) {
        port->repeated.reset();
    } else {
        port->node->take_frame();
    }
    next.start = at;
    next.corrupted = faults_.corrupts();
    const unsigned length = frame_bits(next.frame);
    // A flipped bit is noticed after it: anywhere in the frame, then the error frame follows.
    const unsigned used = next.corrupted ? 1U + static_cast<unsigned>(faults_.pick(length)) + error_frame_bits : length;
    next.end = at + bits(used);
    running_ = next;
    return true;
}

bool ArbitratedBus::complete(Nanoseconds now) {
    if (!running_ || running_->end > now) {
        return false;
    }
    const Transmission done = *running_;
    running_.reset();
    idle_from_ = done.end + bits(intermission_bits);
    busy_.push_back({done.start, idle_from_});
    Port& sender = *ports_[done.port];
    const bool steps_back = sender.gateway || sender.counters.state() >= CanState::error_passive;
    sender.may_send_from = steps_back ? idle_from_ + bits(suspend_bits) : 0;
    if (done.corrupted) {
        end_corrupted(done);
    } else {
        deliver(done);
    }
    return true;
}

void ArbitratedBus::end_corrupted(const Transmission& done) {
    ++errors_;
    const Instant now = instant_of(done.end);
    Port& sender = *ports_[done.port];
    sender.repeated = done.frame;
    if (!sender.gateway) {
        sender.counters.transmit_failed();
        tell_state(sender, now);
    }
    tell_receivers_error(sender, now);
}

void ArbitratedBus::tell_receivers_error(const Port& sender, Instant now) {
    for (auto& port : ports_) {
        if (port.get() != &sender && !port->gateway && takes_part(*port)) {
            port->counters.receive_failed();
            tell_state(*port, now);
        }
    }
}

/// The sender of what is on the wire is no longer there: the others see an error, and the frame is lost.
void ArbitratedBus::break_off(Nanoseconds at) {
    const Transmission lost = *running_;
    running_.reset();
    ++errors_;
    idle_from_ = at + bits(error_frame_bits + intermission_bits);
    busy_.push_back({lost.start, idle_from_});
    tell_receivers_error(*ports_[lost.port], instant_of(at));
}

void ArbitratedBus::deliver(const Transmission& done) {
    ++frames_;
    const Instant now = instant_of(done.end);
    Port& sender = *ports_[done.port];
    worst_latency_ = std::max(worst_latency_, done.end - sender.first_since);
    sender.waits = sender.next() != nullptr;
    sender.first_since = done.end;
    tell(BusFrame{now, done.frame, sender.gateway ? nullptr : sender.node});
    if (!sender.gateway) {
        sender.counters.transmitted();
        if (faults_.switches_off()) {
            sender.counters.switch_off();
        }
        tell_state(sender, now);
    }
    const std::size_t loser = faults_.loses() ? faults_.pick(ports_.size()) : ports_.size();
    for (std::size_t i = 0; i < ports_.size(); ++i) {
        Port& port = *ports_[i];
        if (&port == &sender || !takes_part(port)) {
            continue;
        }
        const bool lost = i == loser && !port.gateway;
        set_overrun(port, lost, now);
        if (!lost) {
            port.counters.received();
            tell_state(port, now);
            port.node->receive(done.frame, now);
        }
    }
}

void ArbitratedBus::set_overrun(Port& port, bool lost, Instant now) {
    if (port.overrun != lost) {
        port.overrun = lost;
        port.node->set_overrun(lost, now);
    }
}

void ArbitratedBus::tell_state(Port& port, Instant now) {
    const CanState state = port.counters.state();
    if (state == port.told) {
        return;
    }
    port.told = state;
    if (state == CanState::bus_off) {
        port.repeated.reset();
        port.back_on_bus = now.us * ns_per_us + bits(bus_off_recovery_bits);
    }
    if (!port.gateway) {
        port.node->set_can_state(state, now);
    }
}

void ArbitratedBus::switch_off(const BusNode& node, Instant now) {
    for (std::size_t i = 0; i < ports_.size(); ++i) {
        Port& port = *ports_[i];
        if (port.node != &node) {
            continue;
        }
        port.counters.switch_off();
        if (running_ && running_->port == i) {
            break_off(now.us * ns_per_us);
        }
        tell_state(port, now);
    }
}

void ArbitratedBus::recover(Nanoseconds now) {
    for (auto& port : ports_) {
        if (port->told == CanState::bus_off && port->back_on_bus <= now) {
            port->counters.recover();
            tell_state(*port, instant_of(port->back_on_bus));
        }
    }
}

Instant ArbitratedBus::next_deadline() const {
    Instant next = running_ ? instant_of(running_->end) : never;
    for (const auto& port : ports_) {
        if (port->told == CanState::bus_off) {
            next = earliest(next, instant_of(port->back_on_bus));
        } else if (!running_ && port->next() != nullptr && takes_part(*port)) {
            next = earliest(next, instant_of(std::max(idle_from_, port->may_send_from)));
        }
    }
    return next;
}

BusReport ArbitratedBus::report(Instant now) const {
    const Nanoseconds end = now.us * ns_per_us;
    const Nanoseconds window = std::min<Nanoseconds>(end, ns_per_s);
    const Nanoseconds begin = end - window;
    Nanoseconds used = 0;
    for (const Busy& one : busy_) {
        const Nanoseconds from = std::max(one.start, begin);
        const Nanoseconds to = std::min(one.end, end);
        used += to > from ? to - from : 0;
    }
    if (running_ && running_->start < end) {
        used += end - std::max(running_->start, begin);
    }
    BusReport report;
    report.frames = frames_;
    report.errors = errors_;
    report.load = window == 0 ? 0.0 : static_cast<double>(used) / static_cast<double>(window);
    report.worst_latency = Duration{(worst_latency_ + ns_per_us - 1) / ns_per_us};
    report.bit_rate = bit_rate_;
    return report;
}

}  // namespace canproof::host
