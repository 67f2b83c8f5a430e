// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/emcy.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

constexpr std::uint32_t error_cured_code = 0x0000U;
constexpr Duration queue_retry = milliseconds(1U);  ///< time to the next attempt when the transmit queue is full

}  // namespace

void Emcy::reset() noexcept {
    enabled_ = false;
    active_ = 0U;
    pending_count_ = 0U;
    queued_count_ = 0U;
    may_send_at_ = Instant{};
    clear_list();
    show_register();
}

static_assert(implements<req::CO_EMCY_012> && implements<req::CO_EMCY_025>);
void Emcy::show_register() noexcept {
    const std::uint8_t value = active_register();
    register_changed_ = register_changed_ || (std::uint32_t{value} != shown_register_);
    shown_register_ = value;
    objects_.write(index::error_register, 0U, value);
}

static_assert(implements<req::CO_EMCY_011> && implements<req::CO_EMCY_018>);
void Emcy::refresh() noexcept {
    enabled_ = false;
    may_send_at_ = Instant{};
    forget_when_switched_off();
    show_register();
    static_assert(implements<req::CO_EMCY_024>);
    if (list_ == ErrorList::history) {
        clear_list();
    }
}

static_assert(implements<req::CO_EMCY_015> && implements<req::CO_EMCY_028> && implements<req::CO_EMCY_029>);
void Emcy::set(const ErrorId error, const bool present, const Instant now, const std::uint8_t channel) noexcept {
    const std::size_t at = static_cast<std::size_t>(error);
    const ErrorRow& row = errors_[at];
    if ((row.code == error_cured_code) || (is_active(at) == present)) {
        return;
    }
    active_ ^= std::uint64_t{1U} << at;
    if (present) {
        channel_[at] = channel;
    }
    static_assert(implements<req::CO_EMCY_019>);
    show_register();
    static_assert(implements<req::CO_EMCY_034>);
    if (present && row.listed) {
        enter_into_list(list_entry(at));
    }
    if (!present && (list_ == ErrorList::active)) {
        remove_from_list(list_entry(at));
    }
    if (row.sent) {
        announce(at, !present, now);
    }
}

void Emcy::report(const ErrorId error, const Instant now) noexcept {
    const std::size_t at = static_cast<std::size_t>(error);
    const ErrorRow& row = errors_[at];
    if (row.code == error_cured_code) {
        return;
    }
    if (row.listed) {
        enter_into_list(list_entry(at));
    }
    if (row.sent) {
        announce(at, false, now);
    }
}

std::uint32_t Emcy::list_entry(const std::size_t error) const noexcept {
    const ErrorRow& row = errors_[error];
    const std::uint32_t detail = std::uint32_t{row.detail} | channel_[error];
    return (detail << 16U) | row.code;
}

std::uint8_t Emcy::active_register() const noexcept {
    std::uint32_t bits{0U};
    std::size_t error{0U};
    std::uint64_t rest{active_};
    while (rest != 0U) {
        if ((rest & 1U) != 0U) {
            bits |= errors_[error].register_bits;
        }
        rest >>= 1U;
        ++error;
    }
    return static_cast<std::uint8_t>(bits);
}

static_assert(implements<req::CO_EMCY_008> && implements<req::CO_EMCY_013> && implements<req::CO_EMCY_026>);
void Emcy::enter_into_list(const std::uint32_t entry) noexcept {
    // Sub-index 1 is the newest entry; the oldest is dropped when all sub-indices are in use.
    const std::uint32_t capacity = list_capacity();
    const std::uint32_t count = objects_.read(index::error_list, 0U);
    const std::uint32_t kept = (count < capacity) ? count : (capacity - 1U);
    for (std::uint32_t sub = kept; sub > 0U; --sub) {
        const std::uint32_t moved = objects_.read(index::error_list, static_cast<std::uint8_t>(sub));
        objects_.write(index::error_list, static_cast<std::uint8_t>(sub + 1U), moved);
    }
    objects_.write(index::error_list, 1U, entry);
    objects_.write(index::error_list, 0U, kept + 1U);
}

static_assert(implements<req::CO_EMCY_007>);
void Emcy::remove_from_list(const std::uint32_t entry) noexcept {
    const std::uint32_t count = objects_.read(index::error_list, 0U);
    std::uint32_t kept{0U};
    for (std::uint32_t sub = 1U; sub <= count; ++sub) {
        const std::uint32_t listed = objects_.read(index::error_list, static_cast<std::uint8_t>(sub));
        if (listed != entry) {
            ++kept;
            objects_.write(index::error_list, static_cast<std::uint8_t>(kept), listed);
        }
    }
    for (std::uint32_t sub = kept + 1U; sub <= count; ++sub) {
        objects_.write(index::error_list, static_cast<std::uint8_t>(sub), 0U);
    }
    objects_.write(index::error_list, 0U, kept);
}

std::uint8_t Emcy::list_capacity() const noexcept {
    constexpr std::uint32_t most_subindices{254U};
    std::uint8_t capacity{1U};  // 1 even without 1003h (error list): a write to an absent entry has no effect
    while ((capacity < most_subindices) && objects_.has(index::error_list, static_cast<std::uint8_t>(capacity + 1U))) {
        ++capacity;
    }
    return capacity;
}

void Emcy::clear_list() noexcept {
    const std::uint32_t capacity = list_capacity();
    for (std::uint8_t sub = 0U; sub <= capacity; ++sub) {
        objects_.write(index::error_list, sub, 0U);
    }
}

/// Queues the message that an error begins or ends.
void Emcy::announce(const std::size_t error, const bool cured, const Instant now) noexcept {
    if (cob_id::is_valid(cob_id_entry())) {
        add_waiting(Pending{static_cast<std::uint8_t>(error), cured}, Side::newest);
        advance(now);
    }
}

static_assert(implements<req::CO_EMCY_006> && implements<req::CO_EMCY_022>);
/// Adds a message before (Side::oldest) or behind (Side::newest) all waiting messages. The waiting message of the same
/// error that lies nearest to this side decides: if it reports the same event, the new message is dropped. If two
/// messages of this error wait already, the new message and the nearest one cancel each other, because one reports the
/// beginning and the other the end. So at most two messages wait for each error, and the last one sent shows its
/// present state. Only the message of report() does not: its error has already ended when the message is sent.
void Emcy::add_waiting(const Pending& told, const Side side) noexcept {
    const std::size_t error = told.error;
    std::size_t nearest{0U};
    std::size_t waiting{0U};
    for (std::size_t i = 0U; i < pending_count_; ++i) {
        if (pending_[i].error == error) {
            nearest = ((waiting == 0U) || (side == Side::newest)) ? i : nearest;
            ++waiting;
        }
    }
    const bool repeats = (waiting > 0U) && (pending_[nearest].cured == told.cured);
    if (repeats) {
        // the same message is waiting already
    } else if (waiting > 1U) {
        forget(nearest);
    } else {
        static_assert(implements<req::CO_EMCY_020>);
        const std::size_t at = (side == Side::newest) ? pending_count_ : 0U;
        for (std::size_t i = pending_count_; i > at; --i) {
            pending_[i] = pending_[i - 1U];
        }
        pending_[at] = told;
        ++pending_count_;
    }
}

static_assert(implements<req::CO_EMCY_035>);
/// The queue keeps the order of frames with one identifier. So the messages that it still has are the latest ones.
void Emcy::take_back() noexcept {
    if (!cob_id::is_valid(cob_id_entry())) {
        return;
    }
    for (std::uint32_t left = queue_.count(queued_id_); (left > 0U) && (queued_count_ > 0U); --left) {
        --queued_count_;
        add_waiting(queued_[queued_count_ % TransmitQueue::capacity], Side::oldest);
    }
}

static_assert(implements<req::CO_EMCY_009> && implements<req::CO_K_EMCY_ID>);
std::uint32_t Emcy::cob_id_entry() const noexcept {
    return objects_.has(index::emcy_cob_id, 0U) ? objects_.read(index::emcy_cob_id, 0U)
                                                : (generated::canopen::emcy_cob_id_base + node_id_);
}

void Emcy::forget(const std::size_t position) noexcept {
    --pending_count_;
    for (std::size_t i = position; i < pending_count_; ++i) {
        pending_[i] = pending_[i + 1U];
    }
}

static_assert(implements<req::CO_EMCY_001> && implements<req::CO_EMCY_010> && implements<req::CO_EMCY_033>);
Frame Emcy::message(const Pending& told) const noexcept {
    Frame frame = data_frame(cob_id::identifier(cob_id_entry()), max_frame_length);
    set_field_le<0U, 2U>(frame.data, told.cured ? error_cured_code : errors_[told.error].code);
    frame.data[2] = shown_register_;
    if (content_ == EmcyContent::listed_errors) {
        frame.data[3] = static_cast<std::uint8_t>(objects_.read(index::error_list, 0U));
    } else if (!told.cured) {
        static_assert(implements<req::CO_EMCY_023>);
        set_field_le<3U, 2U>(frame.data, list_entry(told.error) >> 16U);
    } else {
        // these bytes stay zero in the message for the end of an error
    }
    return frame;
}

static_assert(implements<req::CO_EMCY_004>);
void Emcy::enable(const bool enabled, const Instant now) noexcept {
    enabled_ = enabled;
    advance(now);
}

static_assert(implements<req::CO_EMCY_002> && implements<req::CO_EMCY_003> && implements<req::CO_EMCY_006>);
void Emcy::send_pending(const Instant now) noexcept {
    const Duration inhibit = hundreds_of_microseconds(objects_.read(index::emcy_inhibit_time, 0U));
    while ((pending_count_ > 0U) && (may_send_at_ <= now)) {
        const Frame frame = message(pending_[0]);
        const bool queued = queue_.push(frame);
        if (queued) {
            queued_[queued_count_ % TransmitQueue::capacity] = pending_[0];
            ++queued_count_;
            queued_id_ = frame.id;
            forget(0U);
        }
        may_send_at_ = later(now, queued ? inhibit : queue_retry);
    }
}

static_assert(implements<req::CO_EMCY_005> && implements<req::CO_EMCY_021>);
AbortCode Emcy::before_write(const EntryRef& entry, const std::uint32_t value) const noexcept {
    if (entry.index != index::emcy_cob_id) {
        return AbortCode::none;
    }
    const std::uint32_t current = objects_.read(index::emcy_cob_id, 0U);
    return cob_id::check_change(current, value, cob_id::not_valid, cob_id::is_valid(current));
}

static_assert(implements<req::CO_EMCY_014> && implements<req::CO_EMCY_032>);
void Emcy::after_write(const EntryRef& entry) noexcept {
    if (entry.is(index::error_list, 0U)) {
        clear_list();
    }
    if (entry.index == index::emcy_cob_id) {
        forget_when_switched_off();
    }
}

/// Drops all waiting messages when bit 31 of 1014h (COB-ID EMCY) is set. They are not sent when the bit is cleared
/// again.
static_assert(implements<req::CO_EMCY_002>);
void Emcy::forget_when_switched_off() noexcept {
    if (!cob_id::is_valid(cob_id_entry())) {
        pending_count_ = 0U;
    }
}

}  // namespace canproof
