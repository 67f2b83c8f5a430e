#include "firmware/canopen/receive_pdo.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint8_t with_bit(const std::uint8_t set, const std::size_t number, const bool on) noexcept {
    const std::uint32_t bit = 1U << number;
    return static_cast<std::uint8_t>(on ? (set | bit) : (set & ~bit));
}

}  // namespace

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
    rpdo.identifier = rpdo.parameters.valid ? rpdo.parameters.identifier : ReceivePdo::nobody;
    rpdo.waits = false;
    rpdo.due = never;
    short_ = with_bit(short_, number, false);
    refused_ = with_bit(refused_, number, false);
    overdue_ = with_bit(overdue_, number, false);
}

static_assert(implements<req::CO_PDO_003>);
void ReceivePdos::stop() noexcept {
    for (ReceivePdo& rpdo : rpdos_) {
        rpdo.waits = false;
        rpdo.due = never;
    }
    next_ = never;
}

void ReceivePdos::receive(const Frame& frame, const Instant now) noexcept {
    if (frame.extended) {
        return;
    }
    std::size_t number{0U};
    for (const ReceivePdo& rpdo : rpdos_) {
        if (rpdo.identifier != frame.id) {
            // not for this one
        } else if (frame.remote) {
            answer(number);
        } else {
            take(number, frame, now);
        }
        ++number;
    }
}

/// CAN-CBX-AO412, 7.7.2: an RTR on a receive PDO reads back what it writes. Elsewhere nobody asks a receive PDO.
void ReceivePdos::answer(const std::size_t number) noexcept {
    const ReceivePdo& rpdo = rpdos_[number];
    const bool answers = ((std::uint32_t{answering_remote_} >> number) & 1U) != 0U;
    if (answers && rpdo.parameters.remote_allowed) {
        static_cast<void>(queue_.push(rpdo.mapping.pack(objects_, rpdo.identifier)));
    }
}

static_assert(implements<req::CO_PDO_001>);
void ReceivePdos::take(const std::size_t number, const Frame& frame, const Instant now) noexcept {
    ReceivePdo& rpdo = rpdos_[number];
    static_assert(implements<req::CO_PDO_004> && implements<req::CO_PDO_020>);
    const bool too_short = std::uint32_t{frame.length} < rpdo.mapping.length();
    short_ = with_bit(short_, number, too_short);
    if (too_short) {
        return;
    }
    if (!is_taken(number, frame)) {
        return;
    }
    static_assert(implements<req::CO_PDO_021>);
    if (rpdo.parameters.event.us != 0U) {
        overdue_ = with_bit(overdue_, number, false);
        rpdo.due = now + rpdo.parameters.event;
        schedule();
    }
    if (rpdo.parameters.applied == PdoApplied::at_sync) {
        rpdo.waiting = frame;
        rpdo.waits = true;
    } else {
        rpdo.mapping.apply(frame, objects_, access_, now);
    }
}

/// Whether no value of it is refused, and takes note of that.
static_assert(implements<req::CO_PDO_033> && implements<req::CO_PDO_034>);
bool ReceivePdos::is_taken(const std::size_t number, const Frame& frame) noexcept {
    const bool taken = rpdos_[number].mapping.accepts(frame, objects_, access_);
    refused_ = with_bit(refused_, number, !taken);
    return taken;
}

/// Whether it waits with values that are still taken: a limit may have moved since the reception. It waits no more.
bool ReceivePdos::leaves_waiting(const std::size_t number) noexcept {
    ReceivePdo& rpdo = rpdos_[number];
    if (!rpdo.waits) {
        return false;
    }
    rpdo.waits = false;
    const bool taken = rpdo.mapping.accepts(rpdo.waiting, objects_, access_);
    if (!taken) {
        refused_ = with_bit(refused_, number, true);
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

void ReceivePdos::find_overdue(const Instant now) noexcept {
    for (std::size_t number = 0U; number < rpdos_.size(); ++number) {
        if (rpdos_[number].due <= now) {
            rpdos_[number].due = never;
            overdue_ = with_bit(overdue_, number, true);
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

static_assert(implements<req::CO_PDO_022>);
void ReceivePdos::after_write(const EntryRef& entry) noexcept {
    const std::size_t number = pdo_number(PdoDirection::receive, entry.index);
    if (number < rpdos_.size()) {
        refresh(number);
        schedule();
    }
}

}  // namespace canproof
