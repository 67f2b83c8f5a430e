// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/transmit_pdo.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

/// Returns whether the transmission type is 0 to 240 or 252: the TPDO sends the values that it had at a SYNC.
bool is_sampled_at_sync(const PdoParameters& parameters) noexcept {
    return (parameters.sent == PdoSent::at_sync_after_event) || (parameters.sent == PdoSent::each_nth_sync) ||
           (parameters.sent == PdoSent::sync_sample_on_request);
}

constexpr Instant latest(const Instant a, const Instant b) noexcept {
    return Instant{(a.us < b.us) ? b.us : a.us};
}

}  // namespace

void TransmitPdos::reset() noexcept {
    running_ = false;
    for (std::size_t number = 0U; number < tpdos_.size(); ++number) {
        refresh(number);
    }
    schedule();
}

void TransmitPdos::refresh(const std::size_t number) noexcept {
    TransmitPdo& tpdo = tpdos_[number];
    read_pdo_parameters(objects_, PdoDirection::transmit, number, tpdo.parameters);
    const std::size_t lines = lines_.size() / tpdos_.size();
    tpdo.mapping.resolve(objects_, mapping_object(PdoDirection::transmit, number), lines_.part(number * lines, lines));
    static_assert(implements<req::CO_PDO_006> && implements<req::CO_PDO_053>);
    tpdo.usable = tpdo.parameters.valid && tpdo.mapping.is_usable();
    tpdo.event_driven = tpdo.usable && (tpdo.parameters.sent == PdoSent::on_event);
}

void TransmitPdos::start(const Instant now) noexcept {
    running_ = true;
    for (std::size_t number = 0U; number < tpdos_.size(); ++number) {
        begin(tpdos_[number], now);
    }
    schedule();
}

static_assert(implements<req::CO_PDO_027>);
void TransmitPdos::stop() noexcept {
    running_ = false;
    schedule();
}

static_assert(implements<req::CO_PDO_018> && implements<req::CO_PDO_049>);
void TransmitPdos::begin(TransmitPdo& tpdo, const Instant now) const noexcept {
    const bool is_timed = tpdo.parameters.event.us != 0U;
    const bool is_sent_now = tpdo.event_driven && ((trigger_ == TpdoTrigger::value_change) || is_timed);
    static_assert(implements<req::CO_PDO_044>);
    static_assert(implements<req::CO_PDO_052>);
    tpdo.sampled = false;
    tpdo.pending = is_sent_now;
    tpdo.cycle_begun = false;
    tpdo.syncs = 0U;
    tpdo.inhibited_until = now;
    tpdo.timer_expires = never;
}

bool TransmitPdos::waits_for_changes(const TransmitPdo& tpdo) const noexcept {
    const bool at_once = tpdo.event_driven && (trigger_ == TpdoTrigger::value_change);
    return tpdo.usable && (at_once || (tpdo.parameters.sent == PdoSent::at_sync_after_event));
}

static_assert(implements<req::CO_PDO_015>);
void TransmitPdos::note_change(const std::uint64_t mark, const std::uint16_t index, const std::uint8_t subindex,
                               const Instant now) noexcept {
    for (TransmitPdo& tpdo : tpdos_.part(0U, active_)) {
        static_assert(implements<req::CO_PDO_041>);
        if (((tpdo.watched & mark) != 0U) && tpdo.mapping.maps(index, subindex)) {
            tpdo.pending = true;
            if (tpdo.event_driven) {
                plan(tpdo, now);
            }
        }
    }
}

// The node passes on SYNCs and remote frames in operational only, so sync() and answer() need not check that the PDOs
// run.
void TransmitPdos::sync(const std::uint8_t counter, const bool is_counted) noexcept {
    for (TransmitPdo& tpdo : tpdos_) {
        if (tpdo.usable && is_sampled_at_sync(tpdo.parameters)) {
            sync_one(tpdo, begins_cycle(tpdo, counter, is_counted));
        }
    }
}

/// Returns whether a TPDO that does not count SYNCs yet begins to count with this SYNC.
static_assert(implements<req::CO_PDO_019> && implements<req::CO_PDO_050>);
bool TransmitPdos::begins_cycle(const TransmitPdo& tpdo, const std::uint8_t counter, const bool is_counted) noexcept {
    const std::uint32_t start_value{tpdo.parameters.sync_start};
    return !is_counted || (start_value == 0U) || (std::uint32_t{counter} == start_value);
}

static_assert(implements<req::CO_PDO_013> && implements<req::CO_PDO_014>);
void TransmitPdos::sync_one(TransmitPdo& tpdo, const bool begins_cycle) noexcept {
    bool is_sent{false};
    if (tpdo.parameters.sent == PdoSent::at_sync_after_event) {
        is_sent = tpdo.pending;
        tpdo.pending = false;
    } else if (tpdo.parameters.sent == PdoSent::each_nth_sync) {
        tpdo.cycle_begun = tpdo.cycle_begun || begins_cycle;
        tpdo.syncs = static_cast<std::uint8_t>(tpdo.syncs + (tpdo.cycle_begun ? 1U : 0U));
        is_sent = std::uint32_t{tpdo.syncs} >= tpdo.parameters.type;
        tpdo.syncs = is_sent ? std::uint8_t{0U} : tpdo.syncs;
    } else {
        // sent on request
    }
    // Samples even while bit 30 of the COB-ID forbids remote frames: a client may clear this bit before the next SYNC.
    static_assert(implements<req::CO_PDO_043>);
    tpdo.sample = tpdo.mapping.values(objects_);
    tpdo.sampled = true;
    if (is_sent) {
        send(tpdo, tpdo.sample);
    }
}

static_assert(implements<req::CO_PDO_016>);
void TransmitPdos::answer(const Frame& request, const Instant now) noexcept {
    for (std::size_t number = 0U; (number < tpdos_.size()) && !request.extended; ++number) {
        TransmitPdo& tpdo = tpdos_[number];
        if (!tpdo.usable || !tpdo.parameters.remote_allowed || (tpdo.parameters.identifier != request.id)) {
            continue;
        }
        static_assert(implements<req::CO_PDO_046>);
        if (tpdo.event_driven) {
            tpdo.pending = true;
            plan(tpdo, now);
        } else if (!is_sampled_at_sync(tpdo.parameters)) {
            static_assert(implements<req::CO_PDO_045>);
            send(tpdo, tpdo.mapping.values(objects_));
        } else if (tpdo.sampled) {
            static_assert(implements<req::CO_PDO_043>);
            send(tpdo, tpdo.sample);
        } else {
            // nothing is sent: no values were sampled before the first SYNC
        }
    }
}

void TransmitPdos::advance(const Instant now) noexcept {
    Instant next{never};
    for (TransmitPdo& tpdo : tpdos_.part(0U, active_)) {
        if (tpdo.due <= now) {
            send_event(tpdo, now);
        }
        next = earliest(next, tpdo.due);
    }
    next_ = next;
}

/// Plans the frame for an event of `tpdo` at `event`: as soon as the inhibit time allows.
static_assert(implements<req::CO_PDO_048>);
void TransmitPdos::plan(TransmitPdo& tpdo, const Instant event) noexcept {
    tpdo.due = latest(event, tpdo.inhibited_until);
    next_ = earliest(next_, tpdo.due);
}

/// Restarts the event timer. When the timer itself caused the event, the next interval follows without a gap, so that
/// the period does not drift. Intervals that were missed in a long pause do not lead to additional frames.
void TransmitPdos::restart_timer(TransmitPdo& tpdo, const Instant now) const noexcept {
    const Instant in_step = later(tpdo.pending ? now : tpdo.timer_expires, tpdo.parameters.event);
    tpdo.timer_expires = (in_step > now) ? in_step : later(now, tpdo.parameters.event);
}

static_assert(implements<req::CO_PDO_017> && implements<req::CO_PDO_047>);
inline void TransmitPdos::send_event(TransmitPdo& tpdo, const Instant now) noexcept {
    send(tpdo, tpdo.mapping.values(objects_));
    tpdo.inhibited_until = now + tpdo.parameters.inhibit;
    if (tpdo.parameters.event.us != 0U) {
        restart_timer(tpdo, now);
    }
    tpdo.pending = false;
    tpdo.due = latest(tpdo.timer_expires, tpdo.inhibited_until);
}

void TransmitPdos::send(const TransmitPdo& tpdo, const std::uint64_t values) noexcept {
    static_cast<void>(queue_.push(tpdo.parameters.identifier, tpdo.mapping.length(), values));
}

/// Determines for which value changes each TPDO waits, and when it is due.
void TransmitPdos::schedule() noexcept {
    watched_ = 0U;
    next_ = never;
    active_ = 0U;
    std::uint8_t number{0U};
    for (TransmitPdo& tpdo : tpdos_) {
        ++number;
        active_ = tpdo.usable ? number : active_;
        tpdo.watched = (running_ && waits_for_changes(tpdo)) ? tpdo.mapping.watch_marks() : 0U;
        watched_ |= tpdo.watched;
        tpdo.due = never;
        if (running_ && tpdo.event_driven) {
            plan(tpdo, tpdo.pending ? Instant{} : tpdo.timer_expires);
        }
    }
}

static_assert(implements<req::CO_PDO_025> && implements<req::CO_PDO_051>);
void TransmitPdos::after_write(const EntryRef& entry, const Instant now) noexcept {
    const std::size_t number = pdo_number(PdoDirection::transmit, entry.index);
    if (number >= tpdos_.size()) {
        return;
    }
    TransmitPdo& tpdo = tpdos_[number];
    const PdoParameters before = tpdo.parameters;
    const bool was_usable = tpdo.usable;
    refresh(number);
    const bool is_other = !was_usable || (std::uint32_t{before.type} != tpdo.parameters.type);
    if (running_ && is_other) {
        begin(tpdo, now);
    } else if (before.event.us != tpdo.parameters.event.us) {
        tpdo.timer_expires = (tpdo.parameters.event.us == 0U) ? never : later(now, tpdo.parameters.event);
    } else {
        // the event timer and the count of SYNCs stay as they are
    }
    schedule();
}

}  // namespace canproof
