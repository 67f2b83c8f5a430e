// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/receive_pdo.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

void ReceivePdos::mark(const std::uint32_t failure, const std::size_t number, const bool on) noexcept {
    const std::uint32_t bit = std::uint32_t{1U} << (failure + number);
    failed_ = on ? (failed_ | bit) : (failed_ & ~bit);
    changed_ = true;
}

/// Returns the number of an RPDO, counted from 0. It is called only after an error, so the search need not be
/// fast.
std::size_t ReceivePdos::number_of(const ReceivePdo& wanted) const noexcept {
    std::size_t number{0U};
    while (&rpdos_[number] != &wanted) {
        ++number;
    }
    return number;
}

void ReceivePdos::reset() noexcept {
    for (std::size_t number = 0U; number < rpdos_.size(); ++number) {
        refresh(number);
    }
}

void ReceivePdos::refresh(const std::size_t number) noexcept {
    ReceivePdo& rpdo = rpdos_[number];
    read_pdo_parameters(objects_, PdoDirection::receive, number, rpdo.parameters);
    const std::size_t lines = lines_.size() / rpdos_.size();
    rpdo.mapping.resolve(objects_, mapping_object(PdoDirection::receive, number), lines_.part(number * lines, lines));
    static_assert(implements<req::CO_PDO_006>);
    rpdo.identifier = rpdo.parameters.valid ? rpdo.parameters.identifier : ReceivePdo::nobody;
    rpdo.waits = false;
    rpdo.due = never;
    mark(came_short, number, false);
    mark(came_refused, number, false);
    mark(came_late, number, false);
}

static_assert(implements<req::CO_PDO_036> && implements<req::CO_PDO_066>);
void ReceivePdos::stop() noexcept {
    for (ReceivePdo& rpdo : rpdos_) {
        rpdo.waits = false;
        rpdo.due = never;
    }
    next_ = never;
}

/// Returns whether the frame is long enough and every value is accepted; records the result.
static_assert(implements<req::CO_PDO_004> && implements<req::CO_PDO_037> && implements<req::CO_PDO_020>);
inline bool ReceivePdos::is_taken(const ReceivePdo& rpdo, const Frame& frame) noexcept {
    const bool is_short = std::uint32_t{frame.length} < rpdo.mapping.length();
    const bool taken = is_short ? false : rpdo.mapping.accepts(frame, objects_, access_);
    if (!taken || has_failed()) {
        const std::size_t number = number_of(rpdo);
        mark(came_short, number, is_short);
        static_assert(implements<req::CO_PDO_034>);
        if (!is_short) {
            mark(came_refused, number, !taken);
        }
        static_assert(implements<req::CO_PDO_067>);
        if (taken) {
            mark(came_late, number, false);
        }
    }
    return taken;
}

static_assert(implements<req::CO_PDO_001>);
inline void ReceivePdos::take(ReceivePdo& rpdo, const Frame& frame, const Instant now) noexcept {
    static_assert(implements<req::CO_PDO_033> && implements<req::CO_PDO_065>);
    if (!is_taken(rpdo, frame)) {
        return;
    }
    if (rpdo.parameters.event.us != 0U) {
        static_assert(implements<req::CO_PDO_040> && implements<req::CO_PDO_066>);
        changed_ = changed_ || (rpdo.due == never);
        rpdo.due = later(now, rpdo.parameters.event);
        schedule();
    }
    if (rpdo.parameters.applied == PdoApplied::at_sync) {
        rpdo.waiting = frame;
        rpdo.waits = true;
    } else {
        rpdo.mapping.apply(frame, objects_, access_, now);
    }
}

void ReceivePdos::receive(const Frame& frame, const Instant now) noexcept {
    for (ReceivePdo& rpdo : rpdos_) {
        static_assert(implements<req::CO_PDO_059>);
        if (rpdo.identifier == frame.id) {
            take(rpdo, frame, now);
        }
    }
}

/// Answers a remote frame that has the identifier of a receive PDO with the present values of the mapped entries
/// (CAN-CBX-AO412, 7.7.2). RPDOs outside answering_remote_ do not answer.
static_assert(implements<req::CO_PDO_062> && implements<req::CO_PDO_063>);
void ReceivePdos::answer(const Frame& request) noexcept {
    std::uint32_t answering{answering_remote_};
    for (const ReceivePdo& rpdo : rpdos_) {
        const bool is_asked = (rpdo.identifier == request.id) && !request.extended;
        if (is_asked && ((answering & 1U) != 0U) && rpdo.parameters.remote_allowed) {
            static_cast<void>(queue_.push(rpdo.identifier, rpdo.mapping.length(), rpdo.mapping.values(objects_)));
        }
        answering >>= 1U;
    }
}

/// Returns whether the RPDO has values that wait for a SYNC and are still accepted: a limit may have changed since the
/// reception. Whatever the result is, the values no longer wait afterwards.
bool ReceivePdos::leaves_waiting(const std::size_t number) noexcept {
    ReceivePdo& rpdo = rpdos_[number];
    if (!rpdo.waits) {
        return false;
    }
    rpdo.waits = false;
    const bool taken = rpdo.mapping.accepts(rpdo.waiting, objects_, access_);
    if (!taken) {
        mark(came_refused, number, true);
    }
    return taken;
}

static_assert(implements<req::CO_PDO_002>);
void ReceivePdos::sync(const Instant now) noexcept {
    for (std::size_t number = 0U; number < rpdos_.size(); ++number) {
        if (leaves_waiting(number)) {
            rpdos_[number].mapping.apply(rpdos_[number].waiting, objects_, access_, now);
        }
    }
}

static_assert(implements<req::CO_PDO_021>);
void ReceivePdos::find_overdue(const Instant now) noexcept {
    for (std::size_t number = 0U; number < rpdos_.size(); ++number) {
        if (rpdos_[number].due <= now) {
            rpdos_[number].due = never;
            mark(came_late, number, true);
        }
    }
    schedule();
}

void ReceivePdos::schedule() noexcept {
    next_ = never;
    for (const ReceivePdo& rpdo : rpdos_) {
        next_ = earliest(next_, rpdo.due);
    }
}

static_assert(implements<req::CO_PDO_022> && implements<req::CO_PDO_039>);
void ReceivePdos::after_write(const EntryRef& entry) noexcept {
    const std::size_t number = pdo_number(PdoDirection::receive, entry.index);
    if (number < rpdos_.size()) {
        refresh(number);
        schedule();
    }
}

}  // namespace canproof
