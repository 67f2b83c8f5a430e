// SPDX-License-Identifier: Apache-2.0
#include "host/sim/image/image_device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/time_text.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/frame_text.hpp"

namespace canproof::host {

namespace {

/// Compares bit by bit, so that a NaN equals itself and 0.0 differs from -0.0.
bool are_same(const std::vector<double>& some, const std::vector<double>& others) {
    return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                      [](double a, double b) { return bit_cast<std::uint64_t>(a) == bit_cast<std::uint64_t>(b); });
}

bool are_same(TransmitQueue some, TransmitQueue others) {
    bool same = some.size() == others.size();
    while (same && !some.empty()) {
        same = are_alike(some.pop(), others.pop());
    }
    return same;
}

std::string frames_of(TransmitQueue queue) {
    std::string text;
    while (!queue.empty()) {
        text += (text.empty() ? "" : " ") + format_frame(queue.pop());
    }
    return text.empty() ? "no frame" : text;
}

}  // namespace

ImageDevice::ImageDevice(std::unique_ptr<ImageLink> link, const ImageGreeting& greeting,
                         std::unique_ptr<SimulatedDevice> twin)
    : SimulatedDevice{twin->memory().size()}, twin_{std::move(twin)}, has_own_clock_{greeting.has_own_clock} {
    if (greeting.inputs != twin_->input_names().size() || greeting.outputs != twin_->output_names().size()) {
        throw ImageFailed{
            fmt::format("{} has {} inputs and {} outputs, this program's {} has {} and {}; build both "
                        "from the same sources",
                        link->name(), greeting.inputs, greeting.outputs, greeting.device, twin_->input_names().size(),
                        twin_->output_names().size())};
    }
    calls_ = std::make_unique<ImageCalls>(std::move(link), greeting.outputs, queue_, memory_);
}

void ImageDevice::set_node_id(NodeId node_id) {
    twin_->set_node_id(node_id);
    memory_.bytes() = twin_->memory().bytes();
}

void ImageDevice::power_on(Instant now) {
    follow_queue();
    twin_->memory().bytes() = memory_.bytes();
    twin_->memory().keep_by([this](const std::vector<std::uint8_t>&) { return calls_->has_committed(); });
    twin_->power_on(now);
    calls_->power_on(twin_->inputs(), now);
    compare(now);
}

void ImageDevice::receive(const Frame& frame, Instant now) {
    follow_queue();
    const std::vector<double> before = twin_->inputs();
    calls_->receive(frame, now);
    twin_->receive(frame, now);
    follow_inputs(before, now);
    compare(now);
}

void ImageDevice::advance(Instant now) {
    follow_queue();
    const std::vector<double> before = twin_->inputs();
    calls_->advance(now);
    twin_->advance(now);
    follow_inputs(before, now);
    compare(now);
}

bool ImageDevice::set_input(const std::string& name, double value, Instant now) {
    follow_queue();
    const bool found = twin_->set_input(name, value, now);
    if (found) {
        calls_->set_inputs(twin_->inputs(), now);
        compare(now);
    }
    return found;
}

/// Calls the image again when frames have been sent, because an SDO block upload continues when the queue has room.
Instant ImageDevice::next_deadline() const {
    if (calls_->sent() != 0) {
        follow_queue();
        calls_->look();
    }
    return calls_->state().deadline;
}

/// Returns the node-ID of the image; NodeId::none when the position of its switches is no node-ID.
std::uint8_t ImageDevice::node_id() const {
    const int number = calls_->state().node_id;
    return NodeId{NodeId::is_one(number) ? number : NodeId::none}.value();
}

void ImageDevice::follow_queue() const {
    for (std::size_t sent = has_own_clock_ ? twin_->queue().size() : calls_->sent(); sent > 0; --sent) {
        twin_->queue().pop();
    }
}

void ImageDevice::follow_inputs(const std::vector<double>& before, Instant now) {
    const std::vector<double> after = twin_->inputs();
    if (!are_same(before, after)) {
        calls_->set_inputs(after, now);
    }
}

void ImageDevice::compare(Instant now) const {
    const std::string found = has_own_clock_ ? std::string{} : difference();
    if (!found.empty()) {
        throw ImageFailed{
            fmt::format("{} and this program's firmware differ at {} s: {}; build both from the same sources",
                        calls_->name(), format_seconds(now), found)};
    }
}

std::string ImageDevice::difference() const {
    const DeviceState& image = calls_->state();
    if (!are_same(queue_, twin_->queue())) {
        return fmt::format("the image waits to send {}, this program waits to send {}", frames_of(queue_),
                           frames_of(twin_->queue()));
    }
    const std::vector<double> outputs = twin_->outputs();
    if (!are_same(image.outputs, outputs)) {
        return fmt::format("the outputs of the image are {}, those of this program {}", fmt::join(image.outputs, " "),
                           fmt::join(outputs, " "));
    }
    struct Number {
        const char* what;
        std::uint64_t its;
        std::uint64_t ours;
    };
    for (const Number& one :
         {Number{"deadline in us", image.deadline.us, twin_->next_deadline().us},
          Number{"node-ID", node_id(), twin_->node_id()},
          Number{"NMT state", static_cast<std::uint8_t>(image.nmt), static_cast<std::uint8_t>(twin_->state())},
          Number{"bit rate", image.bit_rate, twin_->bit_rate()}}) {
        if (one.its != one.ours) {
            return fmt::format("the {} of the image is {}, that of this program is {}", one.what, one.its, one.ours);
        }
    }
    return {};
}

}  // namespace canproof::host
