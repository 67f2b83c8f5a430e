// The bounded queue that a device is handed: frames leave it as they would win arbitration on the bus.
#pragma once

#include <array>
#include <cstddef>

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/frame.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

static_assert(implements<req::CO_FRAME_002>);
/// Lowest identifier first, and frames of one identifier in the order in which they were queued: a segment never
/// overtakes the one before it.
class TransmitQueue {
  public:
    /// One SDO answer, EMCY, SYNC, error control and four PDOs are the most that one event can cause; the rest is room
    /// for a driver that drains late, and for a block-upload sub-block.
    static constexpr std::size_t capacity = 32U;

    /// False when the queue is full or closed: the frame is lost.
    bool push(const Frame& frame) noexcept;
    /// The boot-up message of a reset: what waited is forgotten with the state that sent it, and what follows, of
    /// whatever priority, stays behind it.
    void push_boot_up(const Frame& frame) noexcept;
    bool empty() const noexcept { return count_ == 0U; }
    std::size_t size() const noexcept { return count_; }
    /// The frame to be sent next; nullptr when there is none. Good until the queue is touched.
    const Frame* front() const noexcept { return (count_ == 0U) ? nullptr : &frames_[first_]; }
    /// Removes the frame to be sent next. Without one, gives an empty frame.
    Frame pop() noexcept {
        if (count_ == 0U) {
            return Frame{};
        }
        const Frame next = frames_[first_];
        first_ = (first_ + 1U) % capacity;
        --count_;
        boot_up_waits_ = false;
        return next;
    }

    /// Takes back a frame that was popped and could not be sent: it goes in front of all with its identifier. False
    /// when the queue is full; while it is closed the frame is lost, as every other.
    bool put_back(const Frame& frame) noexcept;
    /// Whether the frame to be sent next is the boot-up message: what was popped before it goes out before it or not at
    /// all.
    bool boot_up_waits() const noexcept { return boot_up_waits_; }

    /// While the controller is bus-off nothing can be sent: pending frames are dropped and new ones refused.
    void close() noexcept;
    void open() noexcept { open_ = true; }

  private:
    /// Moves every frame whose identifier is `bound` or higher one place on: the place that becomes free.
    std::size_t make_room(std::uint32_t bound) noexcept;
    Frame& place(const std::size_t at) noexcept { return frames_[(first_ + at) % capacity]; }
    std::uint32_t id_at(const std::size_t at) const noexcept { return frames_[(first_ + at) % capacity].id; }

    std::array<Frame, capacity> frames_{};  ///< a ring, ascending: a frame that is not urgent goes to its end
    std::size_t first_{0U};                 ///< the next one to send
    std::size_t count_{0U};
    bool open_{true};
    bool boot_up_waits_{false};
};

}  // namespace canproof
