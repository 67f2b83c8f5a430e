#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

bool TransmitQueue::push(const Frame& frame) noexcept {
    if (!open_ || (count_ == capacity)) {
        return false;
    }
    std::size_t at{count_};
    while ((at > 0U) && (frames_[at - 1U].id <= frame.id)) {
        frames_[at] = frames_[at - 1U];
        --at;
    }
    frames_[at] = frame;
    ++count_;
    return true;
}

Frame TransmitQueue::pop() noexcept {
    if (count_ == 0U) {
        return Frame{};
    }
    --count_;
    return frames_[count_];
}

void TransmitQueue::close() noexcept {
    count_ = 0U;
    open_ = false;
}

}  // namespace canproof
