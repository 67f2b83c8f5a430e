#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

bool TransmitQueue::push(const Frame& frame) noexcept {
    const bool goes_last = (count_ == 0U) || (id_at(count_ - 1U) <= frame.id);
    if (!open_ || (count_ == capacity)) {
        return false;
    }
    place(goes_last ? count_ : make_room(frame.id + 1U)) = frame;
    ++count_;
    return true;
}

std::size_t TransmitQueue::make_room(const std::uint32_t bound) noexcept {
    const std::size_t first_free = boot_up_waits_ ? 1U : 0U;
    std::size_t at{count_};
    while ((at > first_free) && (id_at(at - 1U) >= bound)) {
        place(at) = place(at - 1U);
        --at;
    }
    return at;
}

bool TransmitQueue::put_back(const Frame& frame) noexcept {
    if (open_ && (count_ == capacity)) {
        return false;
    }
    if (open_) {
        place(make_room(frame.id)) = frame;
        ++count_;
    }
    return true;
}

void TransmitQueue::push_boot_up(const Frame& frame) noexcept {
    count_ = 0U;
    boot_up_waits_ = false;
    boot_up_waits_ = push(frame);
}

void TransmitQueue::close() noexcept {
    count_ = 0U;
    boot_up_waits_ = false;
    open_ = false;
}

}  // namespace canproof
