// SPDX-License-Identifier: Apache-2.0
// Any state of the EMCY service, and the contracts of the functions that its theorems call.
#pragma once

#include "firmware/canopen/emcy.hpp"
#include "properties/proofs/support/contract.hpp"
#include "properties/proofs/support/loop.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

/// The two objects that the sending of emergency messages changes.
struct Sending {
    TransmitQueue queue{};
    Emcy emcy;
};

/// An EMCY service in any consistent state, with a transmit queue that has any frames.
struct AnyEmcy {
    AnyDictionary dictionary{};
    ErrorTable errors{any<ErrorTable>()};
    bool keeps_history{any<bool>()};
    bool counts{any<bool>()};
    Sending sending{
        {},
        Emcy{dictionary.objects, sending.queue, errors, keeps_history ? ErrorList::history : ErrorList::active,
             counts ? EmcyContent::listed_errors : EmcyContent::detail}};
    TransmitQueue& queue{sending.queue};
    Emcy& emcy{sending.emcy};

    AnyEmcy() {
        leave_open(sending);
        emcy.list_ = keeps_history ? ErrorList::history : ErrorList::active;
        emcy.content_ = counts ? EmcyContent::listed_errors : EmcyContent::detail;
        assume(emcy.is_consistent());
        assume(queue.is_bounded());
    }
    bool is_sound() const { return emcy.is_consistent() && queue.is_bounded(); }
    /// Returns whether what no function of the service changes is as it was.
    bool is_same_service() const {
        return (emcy.list_ == (keeps_history ? ErrorList::history : ErrorList::active)) &&
               (emcy.content_ == (counts ? EmcyContent::listed_errors : EmcyContent::detail));
    }
};

/// Returns whether the first `count` waiting messages are about errors of the error table.
inline bool has_errors(const Emcy& emcy, const std::size_t count) {
    bool sound{true};
    for (std::size_t i = 0U; i < Emcy::pending_capacity; ++i) {
        sound = both(sound, !both(i < count, emcy.pending_[i].error >= max_errors));
    }
    return sound;
}

/// Contract of TransmitQueue::insert(): it takes a frame exactly when the queue is open and not full.
inline bool insert_by_contract(TransmitQueue& queue, const Frame /*frame*/) noexcept {
    claim(queue.is_bounded());
    const bool is_taken = queue.open_ && (queue.size() != TransmitQueue::capacity);
    leave_open(queue.frames_);
    queue.end_ += is_taken ? 1U : 0U;
    return is_taken;
}
inline void use_contract_of_insert() {
    use_contract("TransmitQueue::insert", "a_queue_of_any_length_takes_a_frame_when_it_has_room", insert_by_contract);
}

/// Contract of TransmitQueue::count(): no more frames than there are.
inline std::uint32_t count_by_contract(const TransmitQueue& queue, const std::uint32_t /*id*/) noexcept {
    claim(queue.is_bounded());
    const auto found = any<std::uint32_t>();
    assume(found <= queue.size());
    return found;
}

/// Contract of Emcy::forget(): one waiting message less.
inline void forget_by_contract(Emcy& emcy, const std::size_t position) noexcept {
    claim(position < emcy.pending_count_);
    claim(emcy.is_consistent());
    leave_open(emcy.pending_);
    --emcy.pending_count_;
    assume(emcy.is_consistent());
}
inline void use_contract_of_forget() {
    use_contract("Emcy::forget", "a_message_leaves_any_number_of_waiting_messages", forget_by_contract);
}

/// Contract of Emcy::add_waiting(): the service stays consistent.
inline void add_by_contract(Emcy& emcy, const Emcy::Pending& told, const Emcy::Side /*side*/) noexcept {
    claim(emcy.is_consistent());
    claim(told.error < max_errors);
    leave_open(emcy.pending_);
    leave_open(emcy.pending_count_);
    assume(emcy.is_consistent());
}

/// Contract of Emcy::send_pending(): the service stays consistent, and the queue bounded.
inline void send_by_contract(Emcy& emcy, const Instant now) noexcept {
    claim(is_clock_time(now));
    claim(emcy.is_consistent());
    claim(emcy.queue_.is_bounded());
    leave_open(emcy.queue_.frames_);
    leave_open(emcy.queue_.end_);
    leave_open(emcy.pending_);
    leave_open(emcy.pending_count_);
    leave_open(emcy.queued_);
    leave_open(emcy.queued_count_);
    leave_open(emcy.queued_id_);
    leave_open(emcy.may_send_at_);
    assume(emcy.queue_.is_bounded());
    assume(emcy.is_consistent());
    assume((emcy.pending_count_ == 0U) || (now < emcy.may_send_at_));
}

/// Lets the functions that announce an error use contracts.
inline void use_contracts_of_messages() {
    use_contract("Emcy::add_waiting", "a_message_joins_any_number_of_waiting_messages", add_by_contract);
    use_contract("Emcy::send_pending", "any_number_of_messages_is_sent_into_any_queue", send_by_contract);
}

}  // namespace canproof::proofs
