// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/transmit_queue.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

bool TransmitQueue::push(const std::uint32_t id, const std::uint8_t length, const std::uint64_t data) noexcept {
    return append(id, length, data);
}

void TransmitQueue::push_seldom(const std::uint32_t id, const std::uint8_t length, const std::uint64_t data) noexcept {
    static_cast<void>(insert(data_frame(id, length, data)));
}

bool TransmitQueue::insert(const Frame frame) noexcept {
    if (!open_ || (size() == capacity)) {
        return false;
    }
    place(make_room(frame.id + 1U)) = frame;
    ++end_;
    return true;
}

static_assert(implements<req::CO_FRAME_002>);
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

void TransmitQueue::put_back_at_bus_off(const Frame& frame) noexcept {
    if (size() == capacity) {
        --end_;
    }
    static_cast<void>(put_back(frame));
}

std::uint32_t TransmitQueue::count(const std::uint32_t id) const noexcept {
    std::uint32_t found{0U};
    for (std::uint32_t at = first_; at != end_; ++at) {
        found += (id_at(at) == id) ? 1U : 0U;
    }
    return found;
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
