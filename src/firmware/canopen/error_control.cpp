// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/error_control.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

constexpr std::uint32_t toggle_bit = 0x80U;
constexpr std::uint32_t max_node_id = 127U;

/// Returns whether the identifier is one of 701h…77Fh, which CiA 301 reserves for error control (7.3.5).
constexpr bool is_error_control(const std::uint32_t identifier) noexcept {
    return (identifier > generated::canopen::guarding_cob_id_base) &&
           (identifier <= (generated::canopen::guarding_cob_id_base + max_node_id));
}

}  // namespace

static_assert(implements<req::CO_GUARD_004>);
void ErrorControl::refresh() noexcept {
    identifier_ = objects_.has(index::guarding_identifier, 0U)
                      ? cob_id::identifier(objects_.read(index::guarding_identifier, 0U))
                      : (generated::canopen::guarding_cob_id_base + std::uint32_t{node_id_});
    heartbeat_time_ = milliseconds(objects_.read(index::producer_heartbeat_time, 0U));
    const std::uint64_t guard_time = objects_.read(index::guard_time, 0U);
    life_time_ = milliseconds(guard_time * objects_.read(index::life_time_factor, 0U));
}

void ErrorControl::send_state(const std::uint8_t octet) noexcept {
    queue_.push_seldom(identifier_, 1U, octet);
}

static_assert(implements<req::CO_NMT_001> && implements<req::CO_K_GUARDING_ID>);
void ErrorControl::boot_up(const std::uint8_t node_id, const Instant now) noexcept {
    node_id_ = node_id;
    refresh();
    toggle_ = false;
    life_failed_ = false;
    life_deadline_ = never;
    queue_.push_boot_up(data_frame(identifier_, 1U, static_cast<std::uint8_t>(NmtState::initialising)));
    start_heartbeat(now);
}

static_assert(implements<req::CO_GUARD_008> && implements<req::CO_HB_005>);
void ErrorControl::start_heartbeat(const Instant now) noexcept {
    const Duration time = heartbeat_time_;
    next_heartbeat_ = (time.us == 0U) ? never : later(now, time);
    if (time.us != 0U) {
        // A heartbeat producer is not guarded: a node uses one of the two protocols, never both (CiA 301, 7.2.8.2.2.1).
        life_deadline_ = never;
        life_failed_ = false;
    }
}

static_assert(implements<req::CO_GUARD_001> && implements<req::CO_GUARD_002> && implements<req::CO_GUARD_009>);
bool ErrorControl::answer(const Frame& request, const Instant now) noexcept {
    const bool is_request = !request.extended && (request.id == identifier_);
    static_assert(implements<req::CO_GUARD_003>);
    if (!is_request || (heartbeat_time_.us != 0U)) {
        return false;
    }
    const std::uint8_t state = static_cast<std::uint8_t>(state_);
    send_state(toggle_ ? static_cast<std::uint8_t>(state | toggle_bit) : state);
    toggle_ = !toggle_;
    life_failed_ = false;
    // Life guarding starts with the first request, not when its objects are set.
    life_deadline_ = (life_time_.us == 0U) ? never : later(now, life_time_);
    return true;
}

void ErrorControl::act(const Instant now) noexcept {
    static_assert(implements<req::CO_HB_001>);
    if (next_heartbeat_ <= now) {
        send_state(static_cast<std::uint8_t>(state_));
        next_heartbeat_ = later(next_heartbeat_, heartbeat_time_);
        if (next_heartbeat_ <= now) {
            next_heartbeat_ = later(now, heartbeat_time_);
        }
    }
    static_assert(implements<req::CO_GUARD_007>);
    if (life_deadline_ <= now) {
        life_deadline_ = never;
        life_failed_ = true;
    }
}

static_assert(implements<req::CO_GUARD_005>);
AbortCode ErrorControl::before_write(const EntryRef& entry, const std::uint32_t wanted) const noexcept {
    if (entry.index != index::guarding_identifier) {
        return AbortCode::none;
    }
    const bool is_identifier = wanted == cob_id::identifier(wanted);
    const bool fits = is_identifier && (is_error_control(wanted) || !cob_id::is_restricted(wanted));
    return fits ? AbortCode::none : AbortCode::value_range;
}

static_assert(implements<req::CO_GUARD_006>);
void ErrorControl::after_write(const EntryRef& entry, const Instant now) noexcept {
    refresh();
    if (entry.index == index::producer_heartbeat_time) {
        start_heartbeat(now);
    } else if ((entry.index == index::guard_time) || (entry.index == index::life_time_factor)) {
        // If life guarding runs, it continues with the new time. If not, it starts with the next guarding request.
        const bool is_on = life_time_.us != 0U;
        const bool runs = is_on && (life_deadline_ != never);
        life_deadline_ = runs ? later(now, life_time_) : never;
        life_failed_ = is_on && life_failed_;
    } else {
        // 100Eh node guarding identifier: the next message uses the new identifier.
    }
}

}  // namespace canproof
