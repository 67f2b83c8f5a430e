#include "firmware/canopen/transmit_queue.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
namespace canproof {

static_assert(implements<req::CO_FRAME_002>);
bool TransmitQueue::push(const Frame& frame) noexcept {
    if (!open_ || (count_ == capacity)) {
        return false;
    }
    const std::size_t first_free = boot_up_waits_ ? 1U : 0U;
    std::size_t at{count_};
    while ((at > first_free) && (id_at(at - 1U) > frame.id)) {
        place(at) = place(at - 1U);
        --at;
    }
    place(at) = frame;
    ++count_;
    return true;
}

void TransmitQueue::push_boot_up(const Frame& frame) noexcept {
    count_ = 0U;
    boot_up_waits_ = false;
    boot_up_waits_ = push(frame);
}

Frame TransmitQueue::pop() noexcept {
    if (count_ == 0U) {
        return Frame{};
    }
    const Frame& next = frames_[first_];
    first_ = (first_ + 1U) % capacity;
    --count_;
    boot_up_waits_ = false;
    return next;
}

void TransmitQueue::close() noexcept {
    count_ = 0U;
    boot_up_waits_ = false;
    open_ = false;
}

}  // namespace canproof
