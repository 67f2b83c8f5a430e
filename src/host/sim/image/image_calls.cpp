// SPDX-License-Identifier: Apache-2.0
#include "host/sim/image/image_calls.hpp"

#include <array>

namespace canproof::host {

using bridge::Kind;
using bridge::Message;

ImageCalls::ImageCalls(std::unique_ptr<ImageLink> link, std::size_t outputs, TransmitQueue& queue, Memory& memory)
    : link_{std::move(link)}, queue_{queue}, memory_{memory} {
    state_.outputs.resize(outputs);
    Message begin{Kind::begin};
    begin.put(static_cast<std::uint32_t>(memory_.size()));
    link_->send(begin);
}

void ImageCalls::power_on(const std::vector<double>& inputs, Instant now) {
    call(command(Kind::power_on, now, inputs));
}

void ImageCalls::set_inputs(const std::vector<double>& inputs, Instant now) {
    call(command(Kind::set_inputs, now, inputs));
}

void ImageCalls::receive(const Frame& frame, Instant now) {
    Message message = command(Kind::receive, now);
    message.put_frame(frame);
    call(message);
}

void ImageCalls::advance(Instant now) {
    call(command(Kind::advance, now));
}

void ImageCalls::look() {
    call(command(Kind::look));
}

Message ImageCalls::command(Kind kind) const {
    Message message{kind};
    message.put(static_cast<std::uint8_t>(sent()));
    return message;
}

Message ImageCalls::command(Kind kind, Instant now) const {
    Message message = command(kind);
    message.put(now.us);
    return message;
}

Message ImageCalls::command(Kind kind, Instant now, const std::vector<double>& inputs) const {
    Message message = command(kind, now);
    for (const double input : inputs) {
        message.put(input);
    }
    return message;
}

void ImageCalls::call(Message command) {
    link_->send(command);
    Message message = link_->receive();
    while (message.kind() != Kind::state) {
        Message answer = access(message);
        link_->send(answer);
        message = link_->receive();
    }
    take_state(message);
}

Message ImageCalls::access(Message& wanted) {
    const Kind kind = wanted.kind();
    std::array<std::uint8_t, bridge::most_memory_bytes> bytes{};
    std::size_t count = 0;
    bool done = false;
    if (kind == Kind::commit) {
        done = memory_.commit();
        committed_ = done;
    } else {
        const auto at = wanted.take<std::uint32_t>();
        count = wanted.take<std::uint16_t>();
        if (count > bytes.size() || (kind != Kind::read && kind != Kind::write)) {
            link_->refuse();
        }
        done = kind == Kind::read ? memory_.read(at, MutableBytes{bytes.data(), count})
                                  : memory_.write(at, wanted.take_bytes(count));
    }
    if (!wanted.is_sound()) {
        link_->refuse();
    }
    Message answer{Kind::stored};
    answer.put(static_cast<std::uint8_t>(done ? 1U : 0U));
    answer.put_bytes(kind == Kind::read ? ByteView{bytes.data(), count} : ByteView{});
    return answer;
}

/// Reads from `message` the state that the image reports, and puts the frames of the image's queue into `queue_`.
void ImageCalls::take_state(Message& message) {
    state_.deadline = Instant{message.take<std::uint64_t>()};
    state_.node_id = message.take<std::uint8_t>();
    state_.nmt = message.take<NmtState>();
    state_.bit_rate = message.take<std::uint32_t>();
    const bool boot_up_waits = message.take<std::uint8_t>() != 0U;
    waiting_ = message.take<std::uint8_t>();
    queue_ = TransmitQueue{};
    for (std::size_t i = 0; i < waiting_; ++i) {
        const Frame frame = message.take_frame();
        if (boot_up_waits && i == 0) {
            queue_.push_boot_up(frame);
        } else {
            queue_.push(frame);
        }
    }
    for (double& output : state_.outputs) {
        output = message.take<double>();
    }
    if (!message.is_sound() || waiting_ != queue_.size()) {
        link_->refuse();
    }
}

}  // namespace canproof::host
