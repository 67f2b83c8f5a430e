// SPDX-License-Identifier: Apache-2.0
// The statistics of SocketCanBus: frames, load, losses.

#include <fmt/format.h>

#include <algorithm>

#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/socketcan_bus.hpp"

namespace canproof::host {

namespace {

constexpr std::uint64_t ns_per_us = 1000;
constexpr Duration losses_period = milliseconds(1000);

}  // namespace

void SocketCanBus::count_losses(Port& port, std::uint32_t dropped) {
    port.lost += dropped - port.dropped;  // correct even when the kernel's counter has overflowed
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
            notice(fmt::format("{}: {} frames arrived faster than they were read and are lost for {}", interface_,
                               port.lost, port.node == nullptr ? "the log" : port.node->name()));
        }
    }
    if (!roomy_) {
        notice(fmt::format("`sysctl -w net.core.rmem_max={}` or CAP_NET_ADMIN permits larger receive buffers",
                           receive_room));
    }
}

void SocketCanBus::count(const Frame& frame, Instant now) {
    ++frames_;
    if (bit_rate_ != 0) {
        const std::uint64_t end = now.us * ns_per_us;
        load_.add(end - std::min(end, frame_time_ns(frame, bit_rate_)), end);
    }
}

BusReport SocketCanBus::report(Instant now) const {
    BusReport report;
    report.frames = frames_;
    report.errors = errors_;
    for (const Port& port : ports_) {
        const std::uint32_t dropped = port.socket.is_open() ? system_.dropped(port.socket.number()) : port.dropped;
        (port.node == nullptr ? report.lost : report.missed) += port.lost + (dropped - port.dropped);
    }
    report.load = load_.at(now.us * ns_per_us, now.us * ns_per_us);
    report.worst_latency = worst_latency_;
    report.bit_rate = bit_rate_;
    return report;
}

}  // namespace canproof::host
