// SPDX-License-Identifier: Apache-2.0
// Any consistent transmit queue, and what its calls do to it. A theorem says where in the ring the queue begins, and
// how many frames it has.
#pragma once

#include "firmware/canopen/transmit_queue.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

/// Assumes that the queue is consistent. Each pair of neighbours has its own assumption: so the solver sees it on its
/// own.
inline void assume_consistent(const TransmitQueue& queue) {
    assume(queue.is_bounded());
    for (std::size_t i = 1U; i < queue.size(); ++i) {
        assume(queue.is_in_order(i));
    }
}

/// Claims that the queue is consistent, with a claim for each pair of neighbours.
inline void claim_consistent(const TransmitQueue& queue) {
    claim(queue.is_bounded());
    for (std::size_t i = 1U; i < queue.size(); ++i) {
        claim(queue.is_in_order(i));
    }
}

/// Returns any consistent queue of `length` frames that begins at position `place` of the ring buffer.
inline TransmitQueue queue_from(const std::uint32_t place, const std::uint32_t length) {
    TransmitQueue queue{};
    leave_open(queue);
    queue.first_ = (any<std::uint32_t>() * std::uint32_t{TransmitQueue::capacity}) + place;
    queue.end_ = queue.first_ + length;
    assume_consistent(queue);
    return queue;
}

/// Returns any frame with an identifier that a frame can have: 29 bits at most.
inline Frame any_identified_frame() {
    const Frame frame = any<Frame>();
    assume(frame.id <= 0x1FFFFFFFU);
    return frame;
}

inline bool is_same(const Frame& a, const Frame& b) {
    const bool head = both(a.id == b.id, a.length == b.length);
    return both(head, field_le<0U, max_frame_length>(a.data) == field_le<0U, max_frame_length>(b.data));
}

/// Returns whether the frame at position `at` of the queue is sent before another frame that belongs before all frames
/// with the identifier `bound` or a higher one. That is the case for the boot-up message, and for each lower
/// identifier.
inline bool goes_before(const TransmitQueue& queue, const std::size_t at, const std::uint32_t bound) {
    return ((at == 0U) && queue.boot_up_waits_) || (waiting(queue, at).id < bound);
}

/// Splits a theorem by the place at which a frame is put into a queue. The frames before the place go before it. No
/// frame behind the place does. frames_that_go_before_others_come_first() shows that each queue is one of these cases.
inline std::size_t split_by_place(const TransmitQueue& queue, const std::uint32_t length, const std::uint32_t bound) {
    const std::size_t place = each(length + 1U);
    for (std::size_t i = 0U; i < length; ++i) {
        assume(goes_before(queue, i, bound) == (i < place));
    }
    return place;
}

/// Claims that `queue` has the frames of `before`, with `frame` put in at `place`.
inline void claim_put(const TransmitQueue& queue, const TransmitQueue& before, const std::size_t place,
                      const Frame& frame) {
    claim(queue.size() == (before.size() + 1U));
    for (std::size_t i = 0U; i <= before.size(); ++i) {
        const Frame& expected = (i < place) ? waiting(before, i) : ((i == place) ? frame : waiting(before, i - 1U));
        claim(is_same(waiting(queue, i), expected));
    }
}

/// Claims what push() does to a queue. The prover proves the theorem for both overloads of push().
inline void claim_push(TransmitQueue queue, const std::uint32_t length) {
    const TransmitQueue before = queue;
    const Frame frame = any_identified_frame();
    const std::size_t place = split_by_place(queue, length, frame.id + 1U);
    const bool taken = (each(2U) == 0U)
                           ? queue.push(frame)
                           : queue.push(frame.id, frame.length, field_le<0U, max_frame_length>(frame.data));
    claim(taken == (before.open_ && (length < TransmitQueue::capacity)));
    claim_consistent(queue);
    if (taken) {
        claim_put(queue, before, place, frame);
    } else {
        claim(queue.size() == length);
    }
}

/// Claims what put_back() does to a queue.
inline void claim_put_back(TransmitQueue queue, const std::uint32_t length) {
    const TransmitQueue before = queue;
    const Frame frame = any<Frame>();
    const std::size_t place = split_by_place(queue, length, frame.id);
    const bool is_full = before.open_ && (length == TransmitQueue::capacity);
    claim(queue.put_back(frame) == !is_full);
    claim_consistent(queue);
    if (before.open_ && !is_full) {
        claim_put(queue, before, place, frame);
    } else {
        claim(queue.size() == length);
    }
}

/// Claims what pop() does to a queue.
inline void claim_pop(TransmitQueue queue) {
    const std::size_t before = queue.size();
    const Frame* const front = queue.front();
    const std::uint32_t expected = (front == nullptr) ? 0U : front->id;
    const Frame popped = queue.pop();
    claim((front == nullptr) == (before == 0U));
    claim(popped.id == expected);
    claim(queue.size() == ((before == 0U) ? 0U : (before - 1U)));
    claim_consistent(queue);
}

/// Claims what push_boot_up() does to a queue.
inline void claim_boot_up(TransmitQueue queue) {
    const Frame frame = any<Frame>();
    queue.push_boot_up(frame);
    claim(queue.size() == (queue.open_ ? 1U : 0U));
    claim(queue.boot_up_waits() == queue.open_);
    claim(queue.empty() || (queue.front()->id == frame.id));
    claim_consistent(queue);
}

/// Claims what close() and open() do to a queue.
inline void claim_close(TransmitQueue queue) {
    queue.close();
    claim(queue.empty());
    claim(!queue.push(any_identified_frame()));
    claim_consistent(queue);
    queue.open();
    claim(queue.empty());
    claim_consistent(queue);
}

}  // namespace canproof::proofs
