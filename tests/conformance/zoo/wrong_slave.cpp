// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/zoo/wrong_slave.hpp"

#include "tests/conformance/zoo/sdo_frames.hpp"
#include "tests/support/slave.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::test::zoo {

namespace {

host::Part altered(const Distortion& distortion) {
    host::Part part = slave_part();
    if (distortion.part) {
        distortion.part(part);
    }
    return part;
}

}  // namespace

WrongSlave::WrongSlave(Distortion distortion)
    : SimulatedDevice{0},
      distortion_{std::move(distortion)},
      inner_{std::make_unique<host::GenericSimulation>(altered(distortion_))} {}

void WrongSlave::power_on(Instant now) {
    now_ = now;
    queue_ = TransmitQueue{};
    later_.clear();
    notes.clear();
    bytes.clear();
    next_segment_ = 0;
    while (!inner_->queue().empty()) {
        static_cast<void>(inner_->queue().pop());
    }
    inner_->power_on(now);
    move_frames();
}

void WrongSlave::receive(const Frame& frame, Instant now) {
    advance(now);
    follow_request(frame);
    hear(frame);
    move_frames();
}

void WrongSlave::advance(Instant now) {
    now_ = now;
    send_late_ones();
    move_frames();
    while (has_room() && inner_->next_deadline() <= now) {
        inner_->advance(now);
        move_frames();
    }
}

Instant WrongSlave::next_deadline() const {
    const Instant late = later_.empty() ? never : Instant{later_.begin()->first};
    if (has_room()) {
        return earliest(late, inner_->queue().empty() ? inner_->next_deadline() : now_);
    }
    return earliest(late, inner_->next_deadline() > now_ ? inner_->next_deadline() : never);
}

bool WrongSlave::set_input(const std::string& name, double value, Instant now) {
    now_ = now;
    const bool known = inner_->set_input(name, value, now);
    move_frames();
    return known;
}

void WrongSlave::say(const Frame& frame) {
    if (is_boot_up(frame, node_id())) {
        queue_.push_boot_up(frame);
    } else {
        static_cast<void>(queue_.push(frame));
    }
}

Frame WrongSlave::ask(const Frame& request) {
    inner_->receive(request, now_);
    Frame answer{};
    std::vector<Frame> others;
    while (!inner_->queue().empty()) {
        const Frame frame = inner_->queue().pop();
        if (frame.id == sdo_answers + node_id()) {
            answer = frame;
        } else {
            others.push_back(frame);
        }
    }
    for (const Frame& frame : others) {
        static_cast<void>(inner_->queue().push(frame));
    }
    return answer;
}

void WrongSlave::write(std::uint16_t index, std::uint8_t subindex, std::size_t size, std::uint32_t value) {
    static_cast<void>(ask(download(node_id(), index, subindex, size, value)));
}

void WrongSlave::hear(const Frame& frame) {
    if (distortion_.hear) {
        distortion_.hear(*this, frame);
    } else {
        pass(frame);
    }
}

/// Follows a block upload: evaluates the client's requests that start it or acknowledge its segments.
void WrongSlave::follow_request(const Frame& frame) {
    if (!is_sdo_request(*this, frame)) {
        return;
    }
    const bool starts = frame.data[0] == 0xA3U;
    const bool goes_on = frame.data[0] == 0xA2U && next_segment_ != 0;
    next_segment_ = starts || goes_on ? 1 : 0;
}

void WrongSlave::follow_answer(const Frame& frame) {
    says_segment_ =
        next_segment_ != 0 && frame.id == sdo_answers + node_id() && (frame.data[0] & 0x7FU) == next_segment_;
    next_segment_ = static_cast<std::uint8_t>(next_segment_ + (says_segment_ ? 1 : 0));
}

void WrongSlave::move_frames() {
    while (has_room() && !inner_->queue().empty()) {
        const Frame frame = inner_->queue().pop();
        follow_answer(frame);
        if (distortion_.say) {
            distortion_.say(*this, frame);
        } else {
            say(frame);
        }
        says_segment_ = false;
    }
}

void WrongSlave::send_late_ones() {
    while (!later_.empty() && later_.begin()->first <= now_.us) {
        say(later_.begin()->second);
        later_.erase(later_.begin());
    }
}

}  // namespace canproof::test::zoo
