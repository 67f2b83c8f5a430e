// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/heartbeat_consumer.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t time_mask = 0xFFFFU;
constexpr std::uint32_t max_node_id = 127U;

constexpr std::uint32_t node_id_of(const std::uint32_t setting) noexcept {
    return (setting >> 16U) & 0xFFU;
}

constexpr std::uint32_t slot_bit(const std::size_t slot) noexcept {
    return std::uint32_t{1U} << slot;
}

static_assert(implements<req::CO_HB_003>);
/// Returns whether an entry of 1016h (consumer heartbeat time) watches a node. It does not when its time or node-ID is
/// zero or the node-ID is above 127 (CiA 301, 7.5.2.19).
constexpr bool is_active(const std::uint32_t setting) noexcept {
    const std::uint32_t node_id = node_id_of(setting);
    return ((setting & time_mask) != 0U) && (node_id >= 1U) && (node_id <= max_node_id);
}

}  // namespace

void HeartbeatConsumer::reset() noexcept {
    for (std::size_t slot = 0U; slot < max_producers; ++slot) {
        restart(slot);
    }
}

void HeartbeatConsumer::restart(const std::size_t slot) noexcept {
    const std::uint32_t watched = setting(slot);
    watches_[slot] = Watch{};
    failed_ &= ~slot_bit(slot);
    if (is_active(watched)) {
        watches_[slot].identifier = generated::canopen::guarding_cob_id_base + node_id_of(watched);
        watches_[slot].time = milliseconds(watched & time_mask);
        any_ = true;
    }
    schedule();
}

std::uint32_t HeartbeatConsumer::setting(const std::size_t slot) const noexcept {
    return objects_.read(index, static_cast<std::uint8_t>(slot + 1U));
}

std::uint8_t HeartbeatConsumer::producer(const std::size_t slot) const noexcept {
    return static_cast<std::uint8_t>(node_id_of(setting(slot)));
}

static_assert(implements<req::CO_HB_002>);
bool HeartbeatConsumer::hear(const std::uint32_t identifier, const Instant now) noexcept {
    bool is_watched{false};
    for (std::size_t slot = 0U; slot < max_producers; ++slot) {
        Watch& watch = watches_[slot];
        if (identifier == watch.identifier) {
            failed_ &= ~slot_bit(slot);
            watch.deadline = later(now, watch.time);
            is_watched = true;
        }
    }
    schedule();
    return is_watched;
}

static_assert(implements<req::CO_HB_004>);
void HeartbeatConsumer::find_silent(const Instant now) noexcept {
    for (std::size_t slot = 0U; slot < max_producers; ++slot) {
        if (watches_[slot].deadline <= now) {
            watches_[slot].deadline = never;
            failed_ |= slot_bit(slot);
        }
    }
    schedule();
}

void HeartbeatConsumer::schedule() noexcept {
    next_ = never;
    for (const Watch& watch : watches_) {
        next_ = earliest(next_, watch.deadline);
    }
}

AbortCode HeartbeatConsumer::before_write(const EntryRef& entry, const std::uint32_t wanted) const noexcept {
    bool taken{false};
    for (std::size_t slot = 0U; slot < max_producers; ++slot) {
        const std::uint32_t other = setting(slot);
        const bool is_other = (slot + 1U) != entry.row->subindex;
        taken = taken || (is_other && is_active(other) && (node_id_of(other) == node_id_of(wanted)));
    }
    // Two active entries for one producer are refused (CiA 301, 7.5.2.19).
    return (is_active(wanted) && taken) ? AbortCode::parameter_incompatible : AbortCode::none;
}

void HeartbeatConsumer::after_write(const EntryRef& entry) noexcept {
    const std::size_t slot = entry.row->subindex - std::size_t{1U};
    if (slot < max_producers) {
        restart(slot);
    }
}

}  // namespace canproof
