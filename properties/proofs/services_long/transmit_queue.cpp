// SPDX-License-Identifier: Apache-2.0
// Theorems on the transmit queue for each place of the ring at which a queue can begin, and each length. They repeat
// those of services, and have thousands of cases.
#include "firmware/canopen/transmit_queue.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/queue.hpp"

namespace canproof::proofs {

namespace {

constexpr std::uint32_t place_20 = 20U;

std::uint32_t any_length() {
    return each(TransmitQueue::capacity + 1U);
}

std::uint32_t any_place() {
    return each(TransmitQueue::capacity);
}

}  // namespace

void push_finds_the_place_in_any_queue_from_place_20() {
    shows(
        "in a queue of any length that begins at place 20 of its ring, push() takes a frame exactly when the queue is "
        "open and not full, puts it behind all that are not of a higher identifier, and each other frame stays in its "
        "order");
    proves<req::CO_FRAME_002>();
    const std::uint32_t length = any_length();
    claim_push(queue_from(place_20, length), length);
}

void push_finds_the_place() {
    shows(
        "push() takes a frame exactly when the queue is open and not full, puts it behind all that are not of a higher "
        "identifier, and each other frame stays in its order");
    proves<req::CO_FRAME_002>();
    const std::uint32_t place = any_place();
    const std::uint32_t length = any_length();
    claim_push(queue_from(place, length), length);
}

void put_back_goes_in_front_of_its_identifier() {
    shows(
        "put_back() refuses a frame exactly when the queue is open and full, puts it before all of its identifier, and "
        "each other frame stays in its order");
    const std::uint32_t place = any_place();
    const std::uint32_t length = any_length();
    claim_put_back(queue_from(place, length), length);
}

void pop_takes_the_first_frame() {
    shows("pop() takes the frame that front() shows, an empty one of an empty queue, and leaves the rest as it is");
    const std::uint32_t place = any_place();
    claim_pop(queue_from(place, any_length()));
}

void boot_up_empties_the_queue() {
    shows("push_boot_up() leaves the boot-up message alone in an open queue, and nothing in a closed one");
    proves<req::CO_NMT_001>();
    const std::uint32_t place = any_place();
    claim_boot_up(queue_from(place, any_length()));
}

void closing_empties_the_queue() {
    shows("close() leaves the queue empty, and nothing comes in until open()");
    proves<req::CO_EMCY_017>();
    const std::uint32_t place = any_place();
    claim_close(queue_from(place, any_length()));
}

}  // namespace canproof::proofs
