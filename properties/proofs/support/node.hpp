// SPDX-License-Identifier: Apache-2.0
// Helpers for theorems on one service of a node: a dictionary with any values, the invariant of the transmit queue, any
// frame and any time.
#pragma once

#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "generated/cbx_ao412/objects.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

/// Returns any frame that a controller can deliver: at most eight bytes.
inline Frame any_frame() {
    const Frame frame = any<Frame>();
    assume(frame.length <= max_frame_length);
    return frame;
}

/// Returns any time that a clock can have. A clock that counts microseconds from power-on reaches 2^63 after 292,000
/// years.
inline Instant any_time() {
    const Instant now = any<Instant>();
    assume(now.us < (std::uint64_t{1U} << 63U));
    return now;
}

/// The dictionary of the CAN-CBX-AO412, which has objects for error control, heartbeat consumer, SYNC and EMCY. The
/// prover considers all values of its entries.
struct AnyDictionary {
    std::array<std::uint8_t, generated::cbx_ao412::image_size> image{
        any<std::array<std::uint8_t, generated::cbx_ao412::image_size>>()};
    ObjectDictionary objects{generated::cbx_ao412::tables, MutableBytes{image}, LimitAbort::range};
};

/// Returns the frame at position `at` of a queue, counted from 0.
inline const Frame& waiting(const TransmitQueue& queue, const std::size_t at) {
    return queue.frames_[(queue.first_ + at) % TransmitQueue::capacity];
}

/// Returns `a && b` without a branch. The operator && would add a branch for each condition.
inline bool both(const bool a, const bool b) {
    return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0U;
}

/// Returns whether the invariant of a transmit queue between two calls holds: it has at most `capacity` frames, and
/// none while it is closed. Only the first frame can be the boot-up message; the identifiers of the frames behind it
/// ascend.
inline bool is_consistent(const TransmitQueue& queue) {
    bool sound = (queue.size() <= TransmitQueue::capacity) && (queue.open_ || queue.empty()) &&
                 (!queue.boot_up_waits_ || !queue.empty());
    for (std::size_t i = 1U; i < TransmitQueue::capacity; ++i) {
        const bool counts = (i < queue.size()) && !((i == 1U) && queue.boot_up_waits_);
        const bool ascends = waiting(queue, i - 1U).id <= waiting(queue, i).id;
        sound = both(sound, !counts || ascends);
    }
    return sound;
}

}  // namespace canproof::proofs
