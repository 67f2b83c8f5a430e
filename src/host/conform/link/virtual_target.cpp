// SPDX-License-Identifier: Apache-2.0
#include "host/conform/link/virtual_target.hpp"

#include "host/sim/devices/advance_device.hpp"

namespace canproof::host::conform {

void VirtualTarget::Slave::power(bool on, Instant now) {
    while (node_.next_frame() != nullptr) {
        node_.take_frame();
    }
    on_ = on;
    if (on) {
        node_.power_on(now);
    }
}

void VirtualTarget::Slave::receive(const Frame& frame, Instant now) {
    if (on_) {
        node_.receive(frame, now);
    }
}

void VirtualTarget::Slave::set_can_state(CanState state, Instant now) {
    if (on_) {
        node_.set_can_state(state, now);
    }
}

void VirtualTarget::Slave::set_overrun(bool lost, Instant now) {
    if (on_) {
        node_.set_overrun(lost, now);
    }
}

VirtualTarget::VirtualTarget(std::unique_ptr<SimulatedDevice> device, std::uint8_t node_id, std::uint32_t bit_rate,
                             std::string name)
    : name_{std::move(name)}, slave_{std::move(device)}, bus_{"virtual", bit_rate, BusFaultRates{}} {
    slave_.device().set_node_id(node_id);
    bus_.listen([this](const BusFrame& frame) {
        frame_seen_ = true;
        tell({frame.time, frame.frame, frame.sender == &tester_});
    });
    slave_.power(true, Instant{});
    bus_.attach(slave_);
    bus_.attach(tester_);
}

void VirtualTarget::send(const Frame& frame) {
    tester_.put(frame);
    step(now_);
}

void VirtualTarget::power(bool on) {
    slave_.power(on, now_);
    step(now_);
}

Instant VirtualTarget::next_deadline() const {
    const Instant bus = bus_.next_deadline();
    return slave_.is_on() ? earliest(bus, slave_.device().next_deadline()) : bus;
}

void VirtualTarget::step(Instant at) {
    if (slave_.is_on()) {
        advance_device(slave_.device(), slave_.name(), at);
    }
    bus_.advance(at);
}

void VirtualTarget::advance(Instant until) {
    frame_seen_ = false;
    for (Instant due = next_deadline(); due <= until && !frame_seen_; due = next_deadline()) {
        now_ = due < now_ ? now_ : due;
        step(now_);
    }
    if (!frame_seen_ && now_ < until) {
        now_ = until;
    }
}

}  // namespace canproof::host::conform
