// SPDX-License-Identifier: Apache-2.0
// Theorems on heartbeat producer, guarding and life guarding: for any frame, any time, any state and any settings.
#include "firmware/canopen/error_control.hpp"

#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

namespace index = generated::canopen::index;

struct Watched {
    AnyDictionary dictionary{};
    TransmitQueue queue{};
    ErrorControl control{dictionary.objects, queue};

    Watched() {
        leave_open(control);
        assume(control.is_consistent());
    }
};

}  // namespace

void boot_up_begins_error_control() {
    shows("booting up queues one message with a byte 00h, stops life guarding, and leaves error control consistent");
    proves<req::CO_NMT_001, req::CO_HB_005>();
    AnyDictionary dictionary{};
    TransmitQueue queue{};
    ErrorControl control{dictionary.objects, queue};
    leave_open(control);
    const Instant now = any_time();
    control.boot_up(any<std::uint8_t>(), now);
    claim(control.is_consistent());
    claim((queue.size() == 1U) && queue.boot_up_waits());
    claim((queue.front()->id == control.identifier_) && (queue.front()->length == 1U) &&
          (queue.front()->data[0] == 0U));
    const Duration time = milliseconds(dictionary.objects.read(index::producer_heartbeat_time, 0U));
    claim(control.next_deadline() == ((time.us == 0U) ? never : (now + time)));
}

void a_heartbeat_leaves_when_it_is_due() {
    shows("advance() sends the state in one byte exactly when a heartbeat is due, and then none is due until later");
    proves<req::CO_HB_001, req::CO_GUARD_004>();
    Watched node{};
    const Instant now = any_time();
    const bool is_due = node.control.next_heartbeat_ <= now;
    const bool is_silent = node.control.life_deadline_ <= now;
    const bool had_failed = node.control.life_guarding_failed();
    node.control.advance(now);
    claim(node.queue.size() == (is_due ? 1U : 0U));
    claim(!is_due ||
          ((waiting(node.queue, 0U).id == node.control.identifier_) && (waiting(node.queue, 0U).length == 1U) &&
           (waiting(node.queue, 0U).data[0] == static_cast<std::uint8_t>(node.control.state_))));
    claim(node.control.next_deadline() > now);
    claim(node.control.life_guarding_failed() == (had_failed || is_silent));
    claim(node.control.is_consistent());
}

void a_guarding_request_is_answered_once() {
    shows("a guarding request is answered with state and toggle bit exactly when the node sends no heartbeats");
    proves<req::CO_GUARD_001, req::CO_GUARD_009, req::CO_GUARD_002, req::CO_GUARD_003, req::CO_FRAME_001>();
    Watched node{};
    const Frame request = any_frame();
    const Instant now = any_time();
    const bool toggle = node.control.toggle_;
    const bool is_one = !request.extended && (request.id == node.control.identifier_);
    const bool answers = is_one && (node.dictionary.objects.read(index::producer_heartbeat_time, 0U) == 0U);
    claim(node.control.answer(request, now) == answers);
    claim(node.queue.size() == (answers ? 1U : 0U));
    claim(node.control.toggle_ == (answers ? !toggle : toggle));
    const std::uint32_t state = static_cast<std::uint8_t>(node.control.state_);
    claim(!answers || (waiting(node.queue, 0U).data[0] == (toggle ? (state | 0x80U) : state)));
    claim(!answers || (node.control.life_deadline_ ==
                       ((node.control.life_time_.us == 0U) ? never : (now + node.control.life_time_))));
    claim(node.control.is_consistent());
}

void new_settings_keep_error_control_consistent() {
    shows("after a write to 1017h, 100Ch or 100Dh error control is consistent, and sends nothing by it");
    proves<req::CO_GUARD_008, req::CO_GUARD_006>();
    Watched node{};
    const auto which = any<std::uint8_t>();
    const std::uint32_t changed = (which == 0U)   ? index::producer_heartbeat_time
                                  : (which == 1U) ? index::guard_time
                                                  : index::life_time_factor;
    const auto value = any<std::uint32_t>();
    node.dictionary.objects.write(
        index::producer_heartbeat_time, 0U,
        (which == 0U) ? value : node.dictionary.objects.read(index::producer_heartbeat_time, 0U));
    node.dictionary.objects.write(index::guard_time, 0U,
                                  (which == 1U) ? value : node.dictionary.objects.read(index::guard_time, 0U));
    node.dictionary.objects.write(index::life_time_factor, 0U,
                                  (which > 1U) ? value : node.dictionary.objects.read(index::life_time_factor, 0U));
    EntryRow row{};
    node.control.after_write(EntryRef{&row, static_cast<std::uint16_t>(changed)}, any_time());
    claim(node.control.is_consistent());
    claim(node.queue.empty());
}

void a_guarding_identifier_is_taken_as_cia_301_says() {
    shows("100Eh takes 701h to 77Fh and unrestricted identifiers alone; other objects are none of its business");
    proves<req::CO_GUARD_005>();
    Watched node{};
    EntryRow row{};
    const EntryRef entry{&row, any<std::uint16_t>()};
    const auto wanted = any<std::uint32_t>();
    const bool own = (wanted >= 0x701U) && (wanted <= 0x77FU);
    const bool fits = (wanted <= 0x7FFU) && (own || !cob_id::is_restricted(wanted));
    const bool refused = (entry.index == index::guarding_identifier) && !fits;
    claim(node.control.before_write(entry, wanted) == (refused ? AbortCode::value_range : AbortCode::none));
}

}  // namespace canproof::proofs
