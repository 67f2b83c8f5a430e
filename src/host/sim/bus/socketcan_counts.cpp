// SPDX-License-Identifier: Apache-2.0
// The statistics of SocketCanBus: frames, load, losses.

#include <fmt/format.h>

#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/socketcan_bus.hpp"

namespace canproof::host {

namespace {

constexpr Duration load_window = milliseconds(1000);
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
        const std::uint64_t us = (std::uint64_t{frame_bits(frame)} + intermission_bits) * 1000000U / bit_rate_;
        busy_.push_back({now, us});
    }
    while (!busy_.empty() && busy_.front().end + load_window < now) {
        busy_.pop_front();
    }
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
