// SPDX-License-Identifier: Apache-2.0
// Theorems on the transmit queue: from any consistent state each call leads to a consistent state, and no frame
// overtakes a frame that must be sent before it. The queue begins at place 20 of its ring of 32 frames, so a queue of
// more than 12 frames continues at the start of the ring. services_long contains the same theorems for each place.
#include "firmware/canopen/transmit_queue.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/queue.hpp"

namespace canproof::proofs {

namespace {

constexpr std::uint32_t place_20 = 20U;

/// Lengths of a queue that begins at place 20: few frames, frames up to the end of the ring and beyond, one free place,
/// and a full queue.
std::uint32_t some_length() {
    constexpr std::array<std::uint32_t, 8U> lengths{0U, 1U, 2U, 3U, 12U, 13U, 31U, 32U};
    return lengths[each(lengths.size())];
}

TransmitQueue any_queue_from_place_20() {
    return queue_from(place_20, each(TransmitQueue::capacity + 1U));
}

}  // namespace

void a_new_queue_is_consistent() {
    shows("a queue begins empty, open and consistent");
    const TransmitQueue queue{};
    claim(queue.empty());
    claim(queue.open_);
    claim(queue.front() == nullptr);
    claim(queue.is_consistent());
}

void frames_that_go_before_others_come_first() {
    shows(
        "in a queue of any length, a frame before one that goes before an identifier goes before it too; so each "
        "identifier has one place");
    proves<req::CO_FRAME_002>();
    TransmitQueue queue{};
    leave_open(queue);
    queue.first_ = (any<std::uint32_t>() * std::uint32_t{TransmitQueue::capacity}) + place_20;
    assume(queue.is_consistent());
    const auto bound = any<std::uint32_t>();
    for (std::size_t i = 1U; i < TransmitQueue::capacity; ++i) {
        const bool is_there = i < queue.size();
        claim(!is_there || !goes_before(queue, i, bound) || goes_before(queue, i - 1U, bound));
    }
}

void push_finds_the_place_from_place_20() {
    shows(
        "in a queue of 0 to 3, 12, 13, 31 or 32 frames that begins at place 20 of its ring, push() takes a frame "
        "exactly "
        "when the queue is open and not full, puts it behind all that are not of a higher identifier, and each other "
        "frame stays in its order");
    proves<req::CO_FRAME_002>();
    const std::uint32_t length = some_length();
    claim_push(queue_from(place_20, length), length);
}

void put_back_keeps_order_from_place_20() {
    shows(
        "in a queue of 0 to 3, 12, 13, 31 or 32 frames that begins at place 20 of its ring, put_back() refuses a frame "
        "exactly when the queue is open and full, puts it before all of its identifier, and each other frame stays in "
        "its order");
    const std::uint32_t length = some_length();
    claim_put_back(queue_from(place_20, length), length);
}

void pop_takes_the_first_frame_from_place_20() {
    shows(
        "in a queue that begins at place 20 of its ring, pop() takes the frame that front() shows, an empty one of an "
        "empty queue, and leaves the rest as it is");
    claim_pop(any_queue_from_place_20());
}

void boot_up_empties_the_queue_from_place_20() {
    shows(
        "in a queue that begins at place 20 of its ring, push_boot_up() leaves the boot-up message alone in an open "
        "queue, and nothing in a closed one");
    proves<req::CO_NMT_001>();
    claim_boot_up(any_queue_from_place_20());
}

void closing_empties_the_queue_from_place_20() {
    shows("close() leaves a queue that begins at place 20 of its ring empty, and nothing comes in until open()");
    proves<req::CO_EMCY_017>();
    claim_close(any_queue_from_place_20());
}

}  // namespace canproof::proofs
