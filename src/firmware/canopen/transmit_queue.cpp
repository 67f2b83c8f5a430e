// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

inline Frame* TransmitQueue::take_place(const std::uint32_t id) noexcept {
    if (!open_ || (size() == capacity)) {
        return nullptr;
    }
    const bool goes_last = empty() || (id_at(end_ - 1U) <= id);
    Frame& free = place(goes_last ? end_ : make_room(id + 1U));
    ++end_;
    return &free;
}

bool TransmitQueue::push(const Frame& frame) noexcept {
    Frame* const place = take_place(frame.id);
    if (place != nullptr) {
        *place = frame;
    }
    return place != nullptr;
}

bool TransmitQueue::push(const std::uint32_t id, const std::uint8_t length, const std::uint64_t data) noexcept {
    Frame* const place = take_place(id);
    if (place != nullptr) {
        *place = data_frame(id, length);
        set_field_le<0U, max_frame_length>(place->data, data);
    }
    return place != nullptr;
}

std::uint32_t TransmitQueue::make_room(const std::uint32_t bound) noexcept {
    const std::uint32_t first_free = boot_up_waits_ ? (first_ + 1U) : first_;
    std::uint32_t at{end_};
    while ((at != first_free) && (id_at(at - 1U) >= bound)) {
        place(at) = place(at - 1U);
        --at;
    }
    return at;
}

bool TransmitQueue::put_back(const Frame& frame) noexcept {
    if (open_ && (size() == capacity)) {
        return false;
    }
    if (open_) {
        place(make_room(frame.id)) = frame;
        ++end_;
    }
    return true;
}

static_assert(implements<req::CO_FRAME_003>);
void TransmitQueue::push_boot_up(const Frame& frame) noexcept {
    first_ = end_;
    boot_up_waits_ = false;
    boot_up_waits_ = push(frame);
}

void TransmitQueue::close() noexcept {
    first_ = end_;
    boot_up_waits_ = false;
    open_ = false;
}

}  // namespace canproof
