#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

bool TransmitQueue::push(const Frame& frame) noexcept {
    if (!open_ || (count_ == capacity)) {
        return false;
    }
    std::size_t at{count_};
    if (boot_up_waits_) {
        frames_[at] = frames_[at - 1U];
        --at;
    }
    while ((at > 0U) && (frames_[at - 1U].id <= frame.id)) {
        frames_[at] = frames_[at - 1U];
        --at;
    }
    frames_[at] = frame;
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
    --count_;
    boot_up_waits_ = false;
    return frames_[count_];
}

void TransmitQueue::close() noexcept {
    count_ = 0U;
    boot_up_waits_ = false;
    open_ = false;
}

}  // namespace canproof
