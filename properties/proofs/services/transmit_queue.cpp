// SPDX-License-Identifier: Apache-2.0
// Theorems on the transmit queue: from any consistent state each call leads to a consistent state, and no frame
// overtakes a frame that must be sent before it.
#include "firmware/canopen/transmit_queue.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

/// A position in the ring buffer of 32 frames: a queue of more than 12 frames that begins here continues at the start
/// of the buffer.
constexpr std::uint32_t place_20 = 20U;

/// Returns any consistent queue that begins at position `place` of the ring buffer. The prover proves the theorem for
/// each length of the queue.
TransmitQueue queue_from(const std::uint32_t place) {
    TransmitQueue queue{};
    leave_open(queue);
    queue.first_ = (any<std::uint32_t>() * std::uint32_t{TransmitQueue::capacity}) + place;
    queue.end_ = queue.first_ + each(TransmitQueue::capacity + 1U);
    assume(is_consistent(queue));
    return queue;
}

/// Returns any consistent queue. The prover proves the theorem for each position of the ring buffer at which a queue
/// can begin.
TransmitQueue any_queue() {
    return queue_from(each(TransmitQueue::capacity));
}

/// Returns any frame with an identifier that a frame can have: 29 bits at most.
Frame any_identified_frame() {
    const Frame frame = any<Frame>();
    assume(frame.id <= 0x1FFFFFFFU);
    return frame;
}

bool is_same(const Frame& a, const Frame& b) {
    const bool head = both(a.id == b.id, a.length == b.length);
    return both(head, field_le<0U, max_frame_length>(a.data) == field_le<0U, max_frame_length>(b.data));
}

/// Puts a frame into the queue by one of the two overloads of push(). The prover proves the theorem for both.
bool push_either_way(TransmitQueue& queue, const Frame& frame) {
    return (each(2U) == 0U) ? queue.push(frame)
                            : queue.push(frame.id, frame.length, field_le<0U, max_frame_length>(frame.data));
}

/// Returns whether the frame at position `at` of the queue is sent before a new frame with the identifier `id`. That is
/// the case for the boot-up message, and for each frame whose identifier is not higher than `id`.
bool goes_before(const TransmitQueue& queue, const std::size_t at, const std::uint32_t id) {
    return ((at == 0U) && queue.boot_up_waits_) || (waiting(queue, at).id <= id);
}

void push_keeps_order(TransmitQueue queue) {
    const Frame frame = any_identified_frame();
    const std::size_t before = queue.size();
    const bool taken = push_either_way(queue, frame);
    claim(taken == (queue.open_ && (before < TransmitQueue::capacity)));
    claim(queue.size() == (before + (taken ? 1U : 0U)));
    claim(is_consistent(queue));
}

void push_finds_the_place(TransmitQueue queue) {
    const TransmitQueue before = queue;
    const Frame frame = any_identified_frame();
    assume(push_either_way(queue, frame));
    claim(queue.size() == (before.size() + 1U));
    for (std::size_t i = 0U; i <= before.size(); ++i) {
        const Frame& found = waiting(queue, i);
        const bool stays = (i < before.size()) && goes_before(before, i, frame.id);
        const bool moves = (i > 0U) && !goes_before(before, i - 1U, frame.id);
        claim(!stays || is_same(found, waiting(before, i)));
        claim(!moves || is_same(found, waiting(before, i - 1U)));
        claim(stays || moves || is_same(found, frame));
    }
}

void put_back_keeps_order(TransmitQueue queue) {
    const Frame frame = any<Frame>();
    const std::size_t before = queue.size();
    const bool is_full = queue.open_ && (before == TransmitQueue::capacity);
    const bool is_open = queue.open_;
    claim(queue.put_back(frame) == !is_full);
    claim(queue.size() == (before + ((is_open && !is_full) ? 1U : 0U)));
    claim(is_consistent(queue));
}

}  // namespace

void a_new_queue_is_consistent() {
    shows("a queue begins empty, open and consistent");
    const TransmitQueue queue{};
    claim(queue.empty());
    claim(queue.open_);
    claim(queue.front() == nullptr);
    claim(is_consistent(queue));
}

void push_keeps_bound_and_order() {
    shows(
        "push() takes a frame exactly when the queue is open and not full, and leaves it within its bound and in "
        "order");
    proves<req::CO_FRAME_002>();
    push_keeps_order(any_queue());
}

void push_keeps_bound_and_order_from_place_20() {
    shows(
        "in a queue that begins at place 20 of its ring, push() takes a frame exactly when the queue is open and not "
        "full, and leaves it within its bound and in order");
    proves<req::CO_FRAME_002>();
    push_keeps_order(queue_from(place_20));
}

void push_puts_a_frame_behind_those_of_its_identifier() {
    shows(
        "push() puts the frame behind all that are not of a higher identifier, and each other frame stays in its "
        "order");
    proves<req::CO_FRAME_002>();
    push_finds_the_place(any_queue());
}

void push_finds_the_place_from_place_20() {
    shows(
        "in a queue that begins at place 20 of its ring, push() puts the frame behind all that are not of a higher "
        "identifier, and each other frame stays in its order");
    proves<req::CO_FRAME_002>();
    push_finds_the_place(queue_from(place_20));
}

void pop_takes_the_first_frame() {
    shows("pop() takes the frame that front() shows, an empty one of an empty queue, and leaves the rest as it is");
    TransmitQueue queue = any_queue();
    const std::size_t before = queue.size();
    const Frame* const front = queue.front();
    const std::uint32_t expected = (front == nullptr) ? 0U : front->id;
    const Frame popped = queue.pop();
    claim((front == nullptr) == (before == 0U));
    claim(popped.id == expected);
    claim(queue.size() == ((before == 0U) ? 0U : (before - 1U)));
    claim(is_consistent(queue));
}

void put_back_goes_in_front_of_its_identifier() {
    shows("put_back() refuses a frame exactly when the queue is open and full, and leaves the queue consistent");
    put_back_keeps_order(any_queue());
}

void put_back_keeps_order_from_place_20() {
    shows(
        "in a queue that begins at place 20 of its ring, put_back() refuses a frame exactly when the queue is open and "
        "full, and leaves the queue consistent");
    put_back_keeps_order(queue_from(place_20));
}

void boot_up_empties_the_queue() {
    shows("push_boot_up() leaves the boot-up message alone in an open queue, and nothing in a closed one");
    proves<req::CO_NMT_001>();
    TransmitQueue queue = any_queue();
    const Frame frame = any<Frame>();
    queue.push_boot_up(frame);
    claim(queue.size() == (queue.open_ ? 1U : 0U));
    claim(queue.boot_up_waits() == queue.open_);
    claim(queue.empty() || (queue.front()->id == frame.id));
    claim(is_consistent(queue));
}

void closing_empties_the_queue() {
    shows("close() leaves the queue empty, and nothing comes in until open()");
    proves<req::CO_EMCY_017>();
    TransmitQueue queue = any_queue();
    queue.close();
    claim(queue.empty());
    claim(!queue.push(any_identified_frame()));
    claim(is_consistent(queue));
    queue.open();
    claim(queue.empty());
    claim(is_consistent(queue));
}

}  // namespace canproof::proofs
