// SPDX-License-Identifier: Apache-2.0
// Theorems on the EMCY service with any number of waiting messages, and a transmit queue of any length: each function
// leaves the service consistent, and the queue bounded.
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/emcy.hpp"

namespace canproof::proofs {

namespace {

namespace index = generated::canopen::index;

std::uint32_t listed(const AnyEmcy& node) {
    return node.dictionary.objects.read(index::error_list, 0U);
}

/// Returns whether only those members have changed that sending changes, by its contract.
bool changes_by_sending_only(const Before<AnyEmcy>& before, const AnyEmcy& node) {
    const Emcy& emcy = node.emcy;
    return before.holds_except(node.queue.frames_, node.queue.end_, emcy.pending_, emcy.pending_count_, emcy.queued_,
                               emcy.queued_count_, emcy.queued_id_, emcy.may_send_at_);
}

/// The invariants of the loops that move the entries of 1003h (error list). The dictionary contains a counter of
/// changes beside its values, so the loops change it as a whole.
struct ListLoops {
    AnyEmcy& node;
    std::uint32_t count{listed(node)};

    bool is_same_image() const { return node.dictionary.objects.image_.size() == node.dictionary.image.size(); }
    /// The invariant of the loop that moves the entries by one.
    bool operator()(const std::size_t passes, const std::uint64_t sub) const noexcept {
        return is_same_image() && ((sub + passes) <= count);
    }
};

}  // namespace

void a_queue_of_any_length_takes_a_frame_when_it_has_room() {
    shows("a queue of any length, at any place of its ring, takes a frame exactly when it is open and not full");
    TransmitQueue queue{};
    leave_open(queue);
    assume(queue.is_bounded());
    const TransmitQueue before = queue;
    const Before bytes{queue};
    const std::size_t moved = before.size() - (before.boot_up_waits_ ? 1U : 0U);
    const auto invariant = [&](const std::size_t passes) noexcept { return passes <= moved; };
    state_invariant({"TransmitQueue::make_room"}, moved, queue.frames_, invariant);
    const bool is_taken = queue.insert(any<Frame>());
    claim(is_taken == (before.open_ && (before.size() != TransmitQueue::capacity)));
    claim(queue.end_ == (before.end_ + (is_taken ? 1U : 0U)));
    claim(queue.is_bounded());
    claim(bytes.holds_except(queue.frames_, queue.end_));
}

void a_queue_of_any_length_counts_its_own_frames() {
    shows("count() of a queue of any length, at any place of its ring, is at most the number of its frames");
    TransmitQueue queue{};
    leave_open(queue);
    assume(queue.is_bounded());
    const auto invariant = [](const std::size_t passes, const std::uint64_t found) noexcept { return found <= passes; };
    state_invariant({"TransmitQueue::count", "found"}, queue.size(), invariant);
    claim(queue.count(any<std::uint32_t>()) <= queue.size());
}

void a_message_leaves_any_number_of_waiting_messages() {
    shows("a message leaves any number of waiting messages at any position: one fewer waits, each of an error");
    AnyEmcy node{};
    const std::size_t count = node.emcy.pending_count_;
    const std::size_t position = any<std::size_t>();
    assume(position < count);
    const auto invariant = [&](const std::size_t) noexcept { return has_errors(node.emcy, count); };
    state_invariant({"Emcy::forget"}, count - 1U - position, node.emcy.pending_, invariant);
    const Before before{node};
    node.emcy.forget(position);
    claim(node.emcy.pending_count_ == (count - 1U));
    claim(before.holds_except(node.emcy.pending_, node.emcy.pending_count_));
    claim(node.is_sound());
}

void a_message_joins_any_number_of_waiting_messages() {
    shows("of any number of waiting messages, of which each error has at most two, adding one leaves the list sound");
    proves<req::CO_EMCY_006>();
    AnyEmcy node{};
    const std::size_t count = node.emcy.pending_count_;
    const Emcy::Pending told{any<std::uint8_t>(), any<bool>()};
    assume(told.error < max_errors);
    const auto search = [](const std::size_t passes, const std::uint64_t nearest, const std::uint64_t own) noexcept {
        // Each of the 48 errors has at most two waiting messages. So a list of 96 has two of each error.
        assume((passes < Emcy::pending_capacity) || (own >= 2U));
        return (own <= passes) && ((own == 0U) || (nearest < passes));
    };
    const auto moves = [&](const std::size_t passes) noexcept {
        return has_errors(node.emcy, count + ((passes == 0U) ? 0U : 1U));
    };
    state_invariant({"Emcy::add_waiting", "nearest waiting"}, count, search);
    state_invariant({"Emcy::add_waiting", "", 1U}, count, node.emcy.pending_, moves);
    use_contract_of_forget();
    const Emcy::Side side = any<bool>() ? Emcy::Side::newest : Emcy::Side::oldest;
    const Before before{node};
    node.emcy.add_waiting(told, side);
    claim(before.holds_except(node.emcy.pending_, node.emcy.pending_count_));
    claim(node.emcy.pending_count_ <= (count + 1U));
    claim(node.is_sound());
}

void any_number_of_messages_is_sent_into_any_queue() {
    shows("sending any number of messages into any queue ends when none waits or their time has not come");
    proves<req::CO_EMCY_002>();
    AnyEmcy node{};
    const Instant now = any_time();
    const std::size_t count = node.emcy.pending_count_;
    const Before before{node};
    const auto invariant = [&](const std::size_t passes) noexcept {
        const std::size_t waiting = node.emcy.pending_count_;
        const bool is_late = (passes > 0U) && ((waiting + passes) == (count + 1U)) && (now < node.emcy.may_send_at_);
        return node.is_sound() && changes_by_sending_only(before, node) && (((waiting + passes) == count) || is_late);
    };
    state_invariant({"Emcy::send_pending"}, count + 1U, node.sending, invariant);
    use_contract_of_insert();
    use_contract_of_forget();
    node.emcy.send_pending(now);
    claim((node.emcy.pending_count_ == 0U) || (now < node.emcy.may_send_at_));
    claim(changes_by_sending_only(before, node));
    claim(node.is_sound());
}

void an_error_begins_or_ends_in_any_state() {
    shows("whenever an error begins or ends, the EMCY service stays consistent and the queue bounded");
    proves<req::CO_EMCY_015>();
    AnyEmcy node{};
    use_contracts_of_messages();
    const ListLoops list{node};
    const auto removed = [&](const std::size_t passes, const std::uint64_t kept) noexcept {
        return list.is_same_image() && (listed(node) == list.count) && (kept <= passes);
    };
    state_invariant({"Emcy::enter_into_list", "sub"}, list.count, node.dictionary, list);
    state_invariant({"Emcy::remove_from_list", "kept"}, list.count, node.dictionary, removed);
    state_invariant({"Emcy::remove_from_list", "", 1U}, list.count, node.dictionary, removed);
    const auto error = any<std::uint8_t>();
    assume(error < max_errors);
    node.emcy.set(static_cast<ErrorId>(error), any<bool>(), any_time(), any<std::uint8_t>());
    claim(node.is_sound());
}

void an_error_is_reported_in_any_state() {
    shows(
        "whenever an error is reported that is already over, the EMCY service stays consistent and the queue bounded");
    AnyEmcy node{};
    use_contracts_of_messages();
    const ListLoops list{node};
    state_invariant({"Emcy::enter_into_list", "sub"}, list.count, node.dictionary, list);
    const auto error = any<std::uint8_t>();
    assume(error < max_errors);
    node.emcy.report(static_cast<ErrorId>(error), any_time());
    claim(node.is_sound());
}

void messages_are_taken_back_in_any_state() {
    shows("whenever messages are taken back from a queue of any length, the EMCY service stays consistent");
    proves<req::CO_EMCY_035>();
    AnyEmcy node{};
    use_contracts_of_messages();
    use_contract("TransmitQueue::count", "a_queue_of_any_length_counts_its_own_frames", count_by_contract);
    const auto invariant = [&](const std::size_t passes, const std::uint64_t left) noexcept {
        return node.emcy.is_consistent() && node.is_same_service() && ((left + passes) <= TransmitQueue::capacity);
    };
    state_invariant({"Emcy::take_back", "left"}, TransmitQueue::capacity, node.emcy, invariant);
    node.emcy.take_back();
    claim(node.is_sound());
}

void sending_is_allowed_or_stopped_in_any_state() {
    shows("whenever sending is allowed or stopped, or time passes, the EMCY service stays consistent");
    proves<req::CO_EMCY_004>();
    AnyEmcy node{};
    use_contracts_of_messages();
    const bool may_send = any<bool>();
    const Instant now = any_time();
    node.emcy.enable(may_send, now);
    claim(node.emcy.enabled_ == may_send);
    claim(node.is_sound());
    node.emcy.advance(any_time());
    claim(node.is_sound());
}

void the_communication_is_reset_in_any_state() {
    shows("a reset of the EMCY service, of its communication or a write of 1003h or 1014h leaves it consistent");
    AnyEmcy node{};
    const std::uint8_t what = each(3U);
    const auto row = any<EntryRow>();
    const EntryRef entry{&row, any<std::uint16_t>()};
    if (what == 0U) {
        node.emcy.reset();
    } else if (what == 1U) {
        node.emcy.refresh();
    } else {
        node.emcy.after_write(entry);
    }
    claim(node.is_sound());
}

}  // namespace canproof::proofs
