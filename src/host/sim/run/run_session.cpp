// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/run_session.hpp"

#include <algorithm>
#include <utility>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/advance_device.hpp"

namespace canproof::host {

RunSession::RunSession(std::unique_ptr<Bus> bus, std::vector<std::unique_ptr<DeviceNode>> nodes,
                       std::vector<Stimulus> stimuli, const SessionOutputs& outputs)
    : bus_{std::move(bus)},
      nodes_{std::move(nodes)},
      traffic_(nodes_.size()),
      stimuli_{std::move(stimuli)},
      outputs_{outputs},
      log_{outputs.log, outputs.log_format},
      deadlines_{nodes_.size()},
      is_changed_(nodes_.size()) {
    for (std::size_t number = 0; number < nodes_.size(); ++number) {
        DeviceNode& node = *nodes_[number];
        changes_.emplace_back(nodes_.size() > 1 ? node.name() + "." : "");
        numbers_.emplace(&node, number);
        by_name_.emplace(node.name(), number);
        node.on_change([this, number] { note_change(number); });
        note_change(number);
    }
    bus_->listen([this](const BusFrame& frame) { record(frame); });
}

void RunSession::power_on() {
    if (outputs_.outputs != nullptr) {
        *outputs_.outputs << output_heading;
    }
    log_.begin(bus_->interface());
    stimulate(Instant{});
    for (auto& node : nodes_) {
        node->power_on(Instant{});
        bus_->attach(*node);
    }
    bus_->advance(Instant{});
    write_outputs(Instant{});
    observe(Instant{});
}

void RunSession::note_change(std::size_t number) {
    if (!is_changed_[number]) {
        is_changed_[number] = true;
        changed_.push_back(number);
        deadlines_.set(number, never);  // next_deadline() asks the device itself while changed_ contains it
    }
}

void RunSession::follow_deadlines() {
    for (const std::size_t number : changed_) {
        deadlines_.set(number, std::as_const(*nodes_[number]).device().next_deadline());
    }
}

Instant RunSession::next_deadline() const {
    Instant next = earliest(bus_->next_deadline(), deadlines_.first());
    for (const std::size_t number : changed_) {
        next = earliest(next, std::as_const(*nodes_[number]).device().next_deadline());
    }
    return next_stimulus_ < stimuli_.size() ? earliest(next, stimuli_[next_stimulus_].time) : next;
}

void RunSession::advance_to(Instant now) {
    advance_to(now, [] { return true; });
}

void RunSession::advance_to(Instant now, const std::function<bool()>& may_go_on) {
    const Instant known = bus_->poll(now);
    advance_known(earliest(known, now), may_go_on);
}

void RunSession::advance_known(Instant now, const std::function<bool()>& may_go_on) {
    for (Instant due = next_deadline(); due <= now; due = next_deadline()) {
        step(time_.reach(due));
        if (!may_go_on()) {
            return;
        }
    }
    time_.reach(now);
}

bool RunSession::put(const Frame& frame) {
    const bool taken = bus_->put(frame, now());
    step(now());
    return taken;
}

void RunSession::schedule(const Stimulus& stimulus) {
    stimuli_.erase(stimuli_.begin(), stimuli_.begin() + static_cast<std::ptrdiff_t>(next_stimulus_));
    next_stimulus_ = 0;
    const auto later = std::upper_bound(stimuli_.begin(), stimuli_.end(), stimulus.time,
                                        [](Instant time, const Stimulus& one) { return time < one.time; });
    stimuli_.insert(later, stimulus);
}

/// Handles all events of one moment in the order that replay also uses: deadlines, stimuli, frames.
void RunSession::step(Instant at) {
    follow_deadlines();
    for (const std::size_t number : deadlines_.due_at(at)) {
        advance_device(nodes_[number]->device(), nodes_[number]->name(), at);
    }
    stimulate(at);
    bus_->advance(at);
    write_outputs(at);
    observe(at);
}

void RunSession::observe(Instant at) {
    if (outputs_.observer != nullptr) {
        outputs_.observer->on_step(at);
    }
}

void RunSession::stimulate(Instant at) {
    for (; next_stimulus_ < stimuli_.size() && stimuli_[next_stimulus_].time <= at; ++next_stimulus_) {
        const Stimulus& one = stimuli_[next_stimulus_];
        const auto point = one.signal.rfind('.');
        if (point == std::string::npos) {
            for (auto& node : nodes_) {
                // a device without this input ignores the stimulus
                node->set_input(one.signal, one.value, at);
            }
            continue;
        }
        const auto [first, last] = by_name_.equal_range(one.signal.substr(0, point));
        for (auto named = first; named != last; ++named) {
            nodes_[named->second]->set_input(one.signal.substr(point + 1), one.value, at);
        }
    }
}

void RunSession::record(const BusFrame& frame) {
    const LoggedFrame logged{frame.time, bus_->interface(), frame.frame};
    if (outputs_.frames != nullptr) {
        *outputs_.frames << format_candump_line(logged) << '\n';
    }
    log_.write(logged, frame.sender != nullptr);
    const auto sender = numbers_.find(frame.sender);
    if (sender != numbers_.end()) {
        ++traffic_[sender->second].frames;
        traffic_[sender->second].last = logged;
    }
    if (outputs_.observer != nullptr) {
        outputs_.observer->on_frame(frame);
    }
}

/// Writes the outputs of the nodes that have changed; the outputs of the others are the same as before.
void RunSession::write_outputs(Instant at) {
    follow_deadlines();
    std::sort(changed_.begin(), changed_.end());
    for (const std::size_t number : changed_) {
        is_changed_[number] = false;
        if (outputs_.outputs != nullptr) {
            changes_[number].write(*outputs_.outputs, at, std::as_const(*nodes_[number]).device());
        }
    }
    changed_.clear();
}

}  // namespace canproof::host
