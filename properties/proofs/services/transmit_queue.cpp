// SPDX-License-Identifier: Apache-2.0
// The transmit queue: from any consistent state each call leaves a consistent one, and no frame overtakes.
#include "firmware/canopen/transmit_queue.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

TransmitQueue any_queue() {
    TransmitQueue queue{};
    leave_open(queue);
    assume(is_consistent(queue));
    return queue;
}

/// Returns the number of frames in a queue that stay before a new frame with this identifier: the boot-up message, and
/// the frames whose identifier is not higher.
std::size_t place_for(const TransmitQueue& queue, const std::uint32_t id) {
    std::size_t place{0U};
    for (std::size_t i = 0U; i < TransmitQueue::capacity; ++i) {
        const bool stays = ((i == 0U) && queue.boot_up_waits_) || (waiting(queue, i).id <= id);
        place += ((i < queue.size()) && stays) ? 1U : 0U;
    }
    return place;
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
    TransmitQueue queue = any_queue();
    const Frame frame = any<Frame>();
    const std::size_t before = queue.size();
    const bool taken = queue.push(frame);
    claim(taken == (queue.open_ && (before < TransmitQueue::capacity)));
    claim(queue.size() == (before + (taken ? 1U : 0U)));
    claim(is_consistent(queue));
}

void push_puts_a_frame_behind_those_of_its_identifier() {
    shows(
        "push() puts the frame behind all that are not of a higher identifier, and each other frame stays in its "
        "order");
    proves<req::CO_FRAME_002>();
    TransmitQueue queue = any_queue();
    const TransmitQueue before = queue;
    const Frame frame = any<Frame>();
    const std::size_t place = place_for(before, frame.id);
    assume(queue.push(frame));
    const std::size_t looked_at = any<std::size_t>();
    assume(looked_at < queue.size());
    const Frame& found = waiting(queue, looked_at);
    const bool is_new = looked_at == place;
    const Frame& other = waiting(before, looked_at - ((looked_at > place) ? 1U : 0U));
    claim(found.id == (is_new ? frame.id : other.id));
    claim(found.length == (is_new ? frame.length : other.length));
    claim(field_le<0U, max_frame_length>(found.data) ==
          field_le<0U, max_frame_length>(is_new ? frame.data : other.data));
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
    TransmitQueue queue = any_queue();
    const Frame frame = any<Frame>();
    const std::size_t before = queue.size();
    const bool is_full = queue.open_ && (before == TransmitQueue::capacity);
    const bool is_open = queue.open_;
    claim(queue.put_back(frame) == !is_full);
    claim(queue.size() == (before + ((is_open && !is_full) ? 1U : 0U)));
    claim(is_consistent(queue));
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
    claim(!queue.push(any<Frame>()));
    claim(is_consistent(queue));
    queue.open();
    claim(queue.empty());
    claim(is_consistent(queue));
}

}  // namespace canproof::proofs
