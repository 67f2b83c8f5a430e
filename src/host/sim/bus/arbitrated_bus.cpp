// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/arbitrated_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/bit_rate_vote.hpp"
#include "host/sim/bus/can_bits.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t ns_per_us = 1000;
constexpr std::uint64_t ns_per_s = 1000000000;
constexpr std::size_t lines_held = 256;  // number of frames of put() that can wait while the bus is busy

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

void ArbitratedBus::add_port(BusNode& node, bool gateway) {
    Port& port = ports_[next_number_];
    port.node = &node;
    port.number = next_number_;
    port.gateway = gateway;
    ++next_number_;
    if (node.tells_changes()) {
        node.on_change([this, &port] { look_again(port); });
        look_again(port);
    } else {
        watched_.push_back(&port);
    }
}

void ArbitratedBus::attach(BusNode& node) {
    const auto nodes = std::count_if(ports_.begin(), ports_.end(), [](const auto& one) { return !one.second.gateway; });
    if (static_cast<std::size_t>(nodes) == most_nodes) {
        throw InputError{fmt::format("{} is one too many: a CANopen bus has up to {} nodes; run fewer devices",
                                     node.name(), most_nodes)};
    }
    add_port(node, false);
}

void ArbitratedBus::attach_gateway(Gateway& gateway) {
    add_port(gateway, true);
}

void ArbitratedBus::detach_gateway(const Gateway& gateway) {
    const auto found =
        std::find_if(ports_.begin(), ports_.end(), [&](const auto& one) { return one.second.node == &gateway; });
    if (found == ports_.end()) {
        return;
    }
    Port& port = found->second;
    if (running_ && running_->port == &port) {
        break_off(advanced_to_);
    }
    waiting_.set(port.number, nullptr);
    readers_.set(port.number, {});
    for (std::vector<Port*>* const list : {&changed_, &watched_}) {
        list->erase(std::remove(list->begin(), list->end(), &port), list->end());
    }
    ports_.erase(found);
}

bool ArbitratedBus::is_sending(const Gateway& gateway) const {
    return std::any_of(ports_.begin(), ports_.end(), [&](const auto& one) {
        const Port& port = one.second;
        return port.node == &gateway && (port.repeated.has_value() || (running_ && running_->port == &port));
    });
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
    BitRateVote vote;
    for (const auto& [number, port] : ports_) {
        ++inspections_;
        vote.add(port.node->bit_rate());
    }
    bit_rate_ = vote.outcome(bit_rate_);
    rates_differ_ = false;
    tell_bit_rates();
}

void ArbitratedBus::tell_bit_rates() {
    for (auto& [number, port] : ports_) {
        const std::uint32_t before = port.rate;
        port.rate = port.node->bit_rate();
        if (before != 0 && port.rate != before) {
            const char* const outcome = port.rate == bit_rate_
                                            ? "the bus has this bit rate"
                                            : "the bus has another bit rate; the device is unreachable";
            notice(fmt::format("{}: LSS sets {} bit/s; {}", port.node->name(), port.rate, outcome));
        }
    }
}

void ArbitratedBus::advance(Instant now) {
    const Nanoseconds at = now.us * ns_per_us;
    advanced_to_ = at;
    do {
        recover(at);
        look(at);
        if (!running_) {
            if (rates_differ_) {
                follow_bit_rates();
            }
            start(at);
        }
    } while (complete(at));
}

void ArbitratedBus::look_again(Port& port) {
    if (!port.changed) {
        port.changed = true;
        changed_.push_back(&port);
    }
}

void ArbitratedBus::look(Nanoseconds now) {
    for (Port* const port : changed_) {
        port->changed = false;
        look_at(*port, now);
    }
    changed_.clear();
    for (Port* const port : watched_) {
        look_at(*port, now);
    }
}

void ArbitratedBus::look_at(Port& port, Nanoseconds now) {
    ++inspections_;
    rates_differ_ = rates_differ_ || port.node->bit_rate() != port.rate;
    readers_.set(port.number, port.node->filters());
    if (running_ && running_->port == &port) {
        return;  // the end of the transmission makes the bus inspect this port again: complete() or break_off()
    }
    if (!waiting_.has(port.number)) {
        port.first_since = now;
    }
    waiting_.set(port.number, port.next());
}

ArbitratedBus::Port* ArbitratedBus::winner(Nanoseconds at) {
    for (const auto& [rank, number] : waiting_.places()) {
        Port& port = ports_.at(number);
        if (takes_part(port) && port.may_send_from <= at) {
            return &port;
        }
    }
    return nullptr;
}

/// Starts the next frame as soon as the bus is idle, even between two microseconds.
void ArbitratedBus::start(Nanoseconds now) {
    Nanoseconds at = idle_from_ + ns_per_us > now ? idle_from_ : now;
    if (at > now) {
        return;
    }
    Port* port = winner(at);
    if (port == nullptr) {
        at = now;
        port = winner(at);
    }
    if (port == nullptr) {
        return;
    }
    Transmission next;
    next.port = port;
    next.frame = *port->next();
    if (port->repeated) {
        port->repeated.reset();
    } else {
        port->node->take_frame();
    }
    next.start = at;
    next.corrupted = faults_.corrupts();
    const unsigned length = frame_bits(next.frame);
    // A bit error is at a random place in the frame. The error frame follows directly after it.
    const unsigned used = next.corrupted ? 1U + static_cast<unsigned>(faults_.pick(length)) + error_frame_bits : length;
    next.end = at + bits(used);
    running_ = next;
}

bool ArbitratedBus::complete(Nanoseconds now) {
    if (!running_ || running_->end > now) {
        return false;
    }
    const Transmission done = *running_;
    running_.reset();
    idle_from_ = done.end + bits(intermission_bits);
    load_.add(done.start, idle_from_);
    Port& sender = *done.port;
    look_again(sender);
    const bool steps_back = sender.gateway || sender.counters.state() >= CanState::error_passive;
    sender.may_send_from = idle_from_ + (steps_back ? bits(suspend_bits) : 0);
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
    Port& sender = *done.port;
    sender.repeated = done.frame;
    if (!sender.gateway) {
        sender.counters.transmit_failed();
        tell_state(sender, now);
    }
    tell_receivers_error(sender, now);
}

void ArbitratedBus::tell_receivers_error(const Port& sender, Instant now) {
    troubled_ = true;
    for (auto& [number, port] : ports_) {
        if (&port != &sender && !port.gateway && takes_part(port)) {
            port.counters.receive_failed();
            tell_state(port, now);
        }
    }
}

/// Ends the transmission of a sender that no longer takes part. The other nodes see an error, and the frame is lost.
void ArbitratedBus::break_off(Nanoseconds at) {
    const Transmission lost = *running_;
    running_.reset();
    idle_from_ = at + bits(error_frame_bits + intermission_bits);
    load_.add(lost.start, idle_from_);
    ++errors_;
    tell_receivers_error(*lost.port, instant_of(at));
}

void ArbitratedBus::deliver(const Transmission& done) {
    ++frames_;
    const Instant now = instant_of(done.end);
    Port& sender = *done.port;
    worst_latency_ = std::max(worst_latency_, done.end - sender.first_since);
    sender.first_since = done.end;
    tell(BusFrame{now, done.frame, sender.gateway ? nullptr : sender.node});
    if (!sender.gateway) {
        sender.counters.transmitted();
        if (faults_.switches_off()) {
            sender.counters.switch_off();
        }
        tell_state(sender, now);
    }
    const Port* loser = nullptr;
    if (faults_.loses()) {
        const Port& picked =
            std::next(ports_.begin(), static_cast<std::ptrdiff_t>(faults_.pick(ports_.size())))->second;
        loser = picked.gateway ? nullptr : &picked;
    }
    count_reception(sender, loser, now);
    for (const std::size_t number : readers_.of(done.frame)) {
        Port& port = ports_.at(number);
        if (&port != &sender && &port != loser && takes_part(port)) {
            port.node->receive(done.frame, now);
        }
    }
}

/// Updates the error counters of each node after a frame, even of nodes that do not read the frame.
void ArbitratedBus::count_reception(const Port& sender, const Port* loser, Instant now) {
    if (!troubled_ && loser == nullptr) {
        return;
    }
    troubled_ = false;
    for (auto& [number, port] : ports_) {
        ++inspections_;
        if (&port != &sender && takes_part(port)) {
            const bool lost = &port == loser;
            if (port.overrun != lost) {
                port.overrun = lost;
                port.node->set_overrun(lost, now);
            }
            if (!lost) {
                port.counters.received();
                tell_state(port, now);
            }
        }
        troubled_ = troubled_ || port.overrun || port.counters.receive_errors() != 0U;
    }
}

void ArbitratedBus::tell_state(Port& port, Instant now) {
    const CanState state = port.counters.state();
    if (state == port.reported_state) {
        return;
    }
    port.reported_state = state;
    look_again(port);
    if (state == CanState::bus_off) {
        port.repeated.reset();
        off_.push_back(&port);
        port.back_on_bus = now.us * ns_per_us + bits(bus_off_recovery_bits);
    }
    port.node->set_can_state(state, now);
}

void ArbitratedBus::switch_off(const BusNode& node, Instant now) {
    for (auto& [number, port] : ports_) {
        if (port.node == &node) {
            port.counters.switch_off();
            if (running_ && running_->port == &port) {
                break_off(now.us * ns_per_us);
            }
            tell_state(port, now);
        }
    }
}

void ArbitratedBus::recover(Nanoseconds now) {
    for (std::size_t i = 0; i < off_.size();) {
        Port& port = *off_[i];
        if (port.back_on_bus > now) {
            ++i;
            continue;
        }
        off_.erase(off_.begin() + static_cast<std::ptrdiff_t>(i));
        port.counters.recover();
        tell_state(port, instant_of(port.back_on_bus));
    }
}

/// Returns the earliest time at which the port can send; `never` if it has no frame or takes no part in the bus.
Instant ArbitratedBus::may_start(const Port& port) const {
    const bool sends = port.next() != nullptr && takes_part(port);
    return sends ? instant_of(std::max(idle_from_, port.may_send_from)) : never;
}

Instant ArbitratedBus::next_deadline() const {
    Instant next = running_ ? instant_of(running_->end) : never;
    for (const Port* const port : off_) {
        next = earliest(next, instant_of(port->back_on_bus));
    }
    if (running_) {
        return next;
    }
    for (const Port* const port : changed_) {
        next = earliest(next, may_start(*port));
    }
    for (const Port* const port : watched_) {
        next = earliest(next, may_start(*port));
    }
    for (const auto& [rank, number] : waiting_.places()) {
        next = earliest(next, may_start(ports_.at(number)));
        if (next <= instant_of(idle_from_)) {
            return next;  // the bus is idle from here on, so no other port can start earlier
        }
    }
    return next;
}

BusReport ArbitratedBus::report(Instant now) const {
    const Nanoseconds at = now.us * ns_per_us;
    BusReport report;
    report.frames = frames_;
    report.errors = errors_;
    report.load = load_.at(at, running_ ? running_->start : at);
    report.worst_latency = Duration{(worst_latency_ + ns_per_us - 1) / ns_per_us};
    report.bit_rate = bit_rate_;
    return report;
}

}  // namespace canproof::host
