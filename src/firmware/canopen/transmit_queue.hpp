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
    /// The same for a data frame of `length` (0…8) bytes, the first one lowest in `data`: written where it waits.
    bool push(std::uint32_t id, std::uint8_t length, std::uint64_t data) noexcept;
    /// The boot-up message of a reset: what waited is forgotten with the state that sent it, and what follows, of
    /// whatever priority, stays behind it.
    void push_boot_up(const Frame& frame) noexcept;
    bool empty() const noexcept { return first_ == end_; }
    std::size_t size() const noexcept { return end_ - first_; }
    /// The frame to be sent next; nullptr when there is none. Good until the queue is touched.
    const Frame* front() const noexcept { return empty() ? nullptr : &frames_[first_ % capacity]; }
    /// Removes the frame to be sent next. Without one, gives an empty frame.
    Frame pop() noexcept {
        if (empty()) {
            return Frame{};
        }
        const Frame& next = frames_[first_ % capacity];
        ++first_;
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
    /// Where a frame with this identifier waits; nullptr when there is no room.
    Frame* take_place(std::uint32_t id) noexcept;
    /// Moves every frame whose identifier is `bound` or higher one place on: the number of the place that becomes free.
    std::uint32_t make_room(std::uint32_t bound) noexcept;
    Frame& place(const std::uint32_t number) noexcept { return frames_[number % capacity]; }
    std::uint32_t id_at(const std::uint32_t number) const noexcept { return frames_[number % capacity].id; }

    static_assert((capacity & (capacity - 1U)) == 0U, "the numbers of places wrap to where the ring begins");

    std::array<Frame, capacity> frames_{};  ///< a ring, ascending: a frame that is not urgent goes to its end
    std::uint32_t first_{0U};               ///< number of the place of the next one to send
    std::uint32_t end_{0U};                 ///< and of that behind the last one
    bool open_{true};
    bool boot_up_waits_{false};
};

}  // namespace canproof
