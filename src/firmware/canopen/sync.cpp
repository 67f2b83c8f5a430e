// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/sync.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

}  // namespace

bool Sync::is_producer() const noexcept {
    return (objects_.read(index::sync_cob_id, 0U) & cob_id::produces_sync) != 0U;
}

void Sync::allow(const bool allowed, const Instant now) noexcept {
    const bool changed = allowed_ != allowed;
    allowed_ = allowed;
    if (changed) {
        restart(now);
    }
}

static_assert(implements<req::CO_SYNC_011>);
void Sync::restart(const Instant now) noexcept {
    counter_ = 0U;
    identifier_ = cob_id::identifier(objects_.read(index::sync_cob_id, 0U));
    length_ = (objects_.read(index::sync_counter_overflow, 0U) == 0U) ? std::uint8_t{0U} : std::uint8_t{1U};
    const std::uint32_t period_us = objects_.read(index::sync_period, 0U);
    const bool produces = allowed_ && is_producer() && (period_us != 0U);
    next_ = produces ? later(now, microseconds(period_us)) : never;
}

static_assert(implements<req::CO_SYNC_003> && implements<req::CO_SYNC_004> && implements<req::CO_SYNC_005>);
bool Sync::produce(const Instant now) noexcept {
    const std::uint32_t overflow = objects_.read(index::sync_counter_overflow, 0U);
    std::uint8_t sent{0U};
    if (overflow != 0U) {
        counter_ = (counter_ < overflow) ? static_cast<std::uint8_t>(counter_ + 1U) : std::uint8_t{1U};
        sent = counter_;
    }
    queue_.push_seldom(identifier_, length_, sent);
    // The next SYNC is due one period after this one was due, so that the producer does not drift. SYNCs missed in a
    // long pause are not sent later.
    const Duration period = microseconds(objects_.read(index::sync_period, 0U));
    next_ = later(next_, period);
    if (next_ <= now) {
        next_ = later(now, period);
    }
    return true;
}

static_assert(implements<req::CO_SYNC_010> && implements<req::CO_SYNC_007> && implements<req::CO_SYNC_008>);
AbortCode Sync::before_write(const EntryRef& entry, const std::uint32_t value) const noexcept {
    if (entry.index == index::sync_cob_id) {
        const std::uint32_t current = objects_.read(index::sync_cob_id, 0U);
        // Bit 31 of 1005h (COB-ID SYNC) has no meaning (CiA 301, 7.5.2.5): both values are accepted and stored.
        static_assert(implements<req::CO_SYNC_012>);
        return cob_id::check_change(current, value & ~cob_id::not_valid, cob_id::produces_sync, is_producer());
    }
    if (entry.index != index::sync_counter_overflow) {
        return AbortCode::none;
    }
    constexpr std::uint32_t reserved_overflow{1U};
    constexpr std::uint32_t highest_overflow{240U};
    if ((value == reserved_overflow) || (value > highest_overflow)) {
        return AbortCode::value_range;
    }
    static_assert(implements<req::CO_SYNC_006> && implements<req::CO_SYNC_013>);
    const bool cycle_is_set = objects_.read(index::sync_period, 0U) != 0U;
    // 1019h synchronous counter overflow value may change only while 1006h communication cycle period is zero (CiA 301,
    // 7.5.2.22).
    return cycle_is_set ? AbortCode::device_state : AbortCode::none;
}

}  // namespace canproof
