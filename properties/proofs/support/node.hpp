// SPDX-License-Identifier: Apache-2.0
// Helpers for theorems on one service of a node: a dictionary with any values, any frame and any time.
#pragma once

#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "generated/cbx_ao412/objects.hpp"
#include "properties/invariants/both.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

/// Returns any frame that a controller can deliver: at most eight bytes.
inline Frame any_frame() {
    const Frame frame = any<Frame>();
    assume(frame.length <= max_frame_length);
    return frame;
}

/// Returns whether a clock can have this time. A clock that counts microseconds from power-on reaches 2^63 after
/// 292,000 years.
inline bool is_clock_time(const Instant time) {
    return time.us < (std::uint64_t{1U} << 63U);
}

/// Returns any time that a clock can have.
inline Instant any_time() {
    const Instant now = any<Instant>();
    assume(is_clock_time(now));
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

}  // namespace canproof::proofs
