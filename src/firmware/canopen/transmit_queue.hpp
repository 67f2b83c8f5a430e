// SPDX-License-Identifier: Apache-2.0
// The bounded queue of frames to send. The frame with the highest priority on the bus leaves first.
#pragma once

#include <array>
#include <cstddef>

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/frame.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

/// A queue sorted by identifier, lowest first; only a boot-up message goes before all other frames. Frames of one
/// identifier keep their order: a segment never overtakes the one before it.
class TransmitQueue {
  public:
    /// The number of frames for which the queue has room. One event usually causes at most one SDO answer, EMCY, SYNC,
    /// error control message and four PDOs. The rest is room for several emergency messages at once, for a driver that
    /// sends late, and for the segments of a block upload.
    static constexpr std::size_t capacity = 32U;

    /// Queues a frame. Returns false when the queue is full or closed: the frame is lost.
    bool push(const Frame& frame) noexcept { return insert(frame); }
    /// Queues a data frame of `length` (0…8) bytes, first byte lowest in `data`. A frame that goes to the end of the
    /// queue, as most do, is written directly to its place.
    bool push(std::uint32_t id, std::uint8_t length, std::uint64_t data) noexcept;
    /// Queues a data frame that is sent seldom, as push() does, but without the faster way to the end of the queue.
    /// When the queue is full or closed, the frame is lost.
    void push_seldom(std::uint32_t id, std::uint8_t length, std::uint64_t data) noexcept;
    /// Queues a data frame of eight bytes without a function call, because a block upload queues thousands of segments.
    [[gnu::always_inline]] bool push_segment(const std::uint32_t id, const std::uint64_t data) noexcept {
        return append(id, max_frame_length, data);
    }
    /// Queues the boot-up message of a reset. Waiting frames are dropped; later frames stay behind the boot-up message
    /// whatever their priority. While the queue is closed the message is lost.
    void push_boot_up(const Frame& frame) noexcept;
    bool empty() const noexcept { return first_ == end_; }
    std::size_t size() const noexcept { return end_ - first_; }
    /// Returns the next frame to send; nullptr when there is none. Valid until the queue changes.
    const Frame* front() const noexcept { return empty() ? nullptr : &frames_[first_ % capacity]; }
    /// Removes and returns the next frame to send; an empty frame when there is none.
    Frame pop() noexcept {
        if (empty()) {
            return Frame{};
        }
        const Frame& next = frames_[first_ % capacity];
        ++first_;
        boot_up_waits_ = false;
        return next;
    }

    /// Takes back a popped frame that could not be sent. The frame goes before all others with its identifier, but
    /// behind a waiting boot-up message. Returns false when the queue is full. While the queue is closed the frame is
    /// lost, and the function returns true.
    bool put_back(const Frame& frame) noexcept;
    /// Takes back a popped frame that could not be sent because the controller is bus-off, as put_back() does. If the
    /// queue is full, its last frame is dropped instead.
    void put_back_at_bus_off(const Frame& frame) noexcept;
    /// Returns the number of waiting frames with this identifier.
    std::uint32_t count(std::uint32_t id) const noexcept;
    /// Returns whether the next frame to send is the boot-up message. Before that message, the driver must send or drop
    /// every frame that it popped earlier.
    bool boot_up_waits() const noexcept { return boot_up_waits_; }

    /// Drops waiting frames and refuses new ones until open(): the controller is bus-off or LSS changes the bit rate.
    void close() noexcept;
    void open() noexcept { open_ = true; }

    /// Returns whether the invariant between two calls holds (properties/invariants): is_bounded(), and is_in_order()
    /// for each frame. The identifiers of the frames thus ascend, except behind a boot-up message that waits.
    bool is_consistent() const noexcept;
    /// Returns whether the queue has at most `capacity` frames, and none while it is closed. A boot-up message that
    /// waits is one of them.
    bool is_bounded() const noexcept;
    /// Returns whether the frame at position `at` (1 or more, counted from the next frame to send) may follow the one
    /// before it.
    bool is_in_order(std::size_t at) const noexcept;

  private:
    /// Returns whether the queue is open and has room, and a frame with this identifier goes behind all others.
    bool goes_last(const std::uint32_t id) const noexcept {
        return open_ && (empty() || ((size() != capacity) && (id_at(end_ - 1U) <= id)));
    }
    [[gnu::always_inline]] bool append(const std::uint32_t id, const std::uint8_t length,
                                       const std::uint64_t data) noexcept {
        static_assert(implements<req::CO_FRAME_002>);
        if (!goes_last(id)) {
            return insert(data_frame(id, length, data));
        }
        set_data_frame(place(end_), id, length, data);
        ++end_;
        return true;
    }
    /// Queues a frame at the place that its identifier demands.
    [[gnu::noinline]] bool insert(Frame frame) noexcept;
    /// Moves every frame with an identifier of `bound` or higher back by one place. Returns the number of the free
    /// place.
    std::uint32_t make_room(std::uint32_t bound) noexcept;
    Frame& place(const std::uint32_t number) noexcept { return frames_[number % capacity]; }
    std::uint32_t id_at(const std::uint32_t number) const noexcept { return frames_[number % capacity].id; }

    static_assert((capacity & (capacity - 1U)) == 0U, "the numbers of places wrap to where the ring begins");

    std::uint32_t first_{0U};  ///< number of the place of the next frame to send
    std::uint32_t end_{0U};    ///< number of the place behind the last frame
    bool open_{true};
    bool boot_up_waits_{false};
    /// A ring in ascending order of identifiers: most frames go to its end. It lies behind the short members, which an
    /// instruction of two bytes then reaches.
    std::array<Frame, capacity> frames_{};
};

}  // namespace canproof
