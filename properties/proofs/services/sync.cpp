// SPDX-License-Identifier: Apache-2.0
// Theorems on SYNC producer and consumer, for any frame, any time, any state and any settings.
#include "firmware/canopen/sync.hpp"

#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

namespace index = generated::canopen::index;

struct Synchronised {
    AnyDictionary dictionary{};
    TransmitQueue queue{};
    Sync sync{dictionary.objects, queue};

    Synchronised() {
        leave_open(sync);
        assume(sync.is_consistent());
    }
};

}  // namespace

void a_sync_is_told_from_other_frames() {
    shows(
        "a frame is a SYNC exactly when it is a base data frame on the identifier of 1005h; its length is that of "
        "1019h");
    proves<req::CO_SYNC_001, req::CO_SYNC_002, req::CO_SYNC_009, req::CO_FRAME_001>();
    Synchronised node{};
    const Frame frame = any_frame();
    const std::uint32_t identifier = node.dictionary.objects.read(index::sync_cob_id, 0U) & 0x7FFU;
    claim(node.sync.is_sync(frame) == ((frame.id == identifier) && !frame.extended && !frame.remote));
    const bool counts = node.dictionary.objects.read(index::sync_counter_overflow, 0U) != 0U;
    claim(node.sync.has_length(frame) == (frame.length == (counts ? 1U : 0U)));
    claim(node.sync.counter_of(frame) == (counts ? frame.data[0] : 0U));
}

void a_sync_leaves_when_it_is_due() {
    shows("advance() sends one SYNC exactly when it is due, with the next counter, and then none is due until later");
    proves<req::CO_SYNC_003, req::CO_SYNC_004, req::CO_SYNC_005>();
    Synchronised node{};
    const Instant now = any_time();
    const std::uint32_t overflow = node.dictionary.objects.read(index::sync_counter_overflow, 0U);
    const std::uint32_t before = node.sync.produced_counter();
    const bool is_due = node.sync.next_deadline() <= now;
    claim(node.sync.advance(now) == is_due);
    claim(node.queue.size() == (is_due ? 1U : 0U));
    claim(node.sync.next_deadline() > now);
    claim(node.sync.is_consistent());
    if (is_due) {
        const Frame& sent = waiting(node.queue, 0U);
        const std::uint32_t next = (before < overflow) ? (before + 1U) : 1U;
        claim(sent.id == node.sync.identifier_);
        claim(sent.length == ((overflow == 0U) ? 0U : 1U));
        claim((overflow == 0U) || ((sent.data[0] == next) && (next <= overflow)));
    }
}

void new_settings_keep_sync_consistent() {
    shows("whatever 1005h, 1006h and 1019h hold and the service did before, reading them again leaves it consistent");
    proves<req::CO_SYNC_003>();
    AnyDictionary dictionary{};
    TransmitQueue queue{};
    Sync sync{dictionary.objects, queue};
    leave_open(sync);
    const Instant now = any_time();
    sync.after_write(now);
    claim(sync.is_consistent());
    claim(sync.next_deadline() > now);
    sync.allow(any<bool>(), now);
    claim(sync.is_consistent());
    claim(sync.next_deadline() > now);
    claim(queue.empty());
}

void a_counter_overflow_is_taken_as_cia_301_says() {
    shows("1019h takes 0 and 2 to 240 alone, and only while 1006h is zero; other objects are none of its business");
    proves<req::CO_SYNC_006, req::CO_SYNC_007>();
    Synchronised node{};
    EntryRow row{};
    const EntryRef entry{&row, any<std::uint16_t>()};
    assume(entry.index != index::sync_cob_id);
    const auto value = any<std::uint32_t>();
    const bool reserved = (value == 1U) || (value > 240U);
    const bool runs = node.dictionary.objects.read(index::sync_period, 0U) != 0U;
    const AbortCode expected = reserved ? AbortCode::value_range : (runs ? AbortCode::device_state : AbortCode::none);
    const bool own = entry.index == index::sync_counter_overflow;
    claim(node.sync.before_write(entry, value) == (own ? expected : AbortCode::none));
}

void a_sync_identifier_is_taken_as_cia_301_says() {
    shows(
        "1005h takes unrestricted identifiers beside bits 30 and 31, and another identifier only while it produces no "
        "SYNC");
    proves<req::CO_SYNC_010, req::CO_SYNC_008, req::CO_SYNC_012>();
    Synchronised node{};
    EntryRow row{};
    const EntryRef entry{&row, static_cast<std::uint16_t>(index::sync_cob_id)};
    const auto value = any<std::uint32_t>();
    const std::uint32_t current = node.dictionary.objects.read(index::sync_cob_id, 0U);
    const bool well_formed = ((value & 0x3FFFF800U) == 0U) && !cob_id::is_restricted(value & 0x7FFU);
    const bool moves = (value & 0x7FFU) != (current & 0x7FFU);
    const bool produces = (current & 0x40000000U) != 0U;
    const AbortCode answer = node.sync.before_write(entry, value);
    claim((answer == AbortCode::value_range) == !well_formed);
    claim((answer == AbortCode::device_state) == (well_formed && moves && produces));
    claim((answer == AbortCode::none) == (well_formed && !(moves && produces)));
}

}  // namespace canproof::proofs
