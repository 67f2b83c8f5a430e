// SPDX-License-Identifier: Apache-2.0
// Errors of the bus and of the device: the node reports them and changes to the NMT state that 1029h error behaviour
// demands.

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

constexpr std::uint32_t communication_error_subindex = 1U;
// Values of 1029h error behaviour (CiA 301, 7.5.2.32).
constexpr std::uint32_t to_pre_operational = 0U;
constexpr std::uint32_t no_change = 1U;
constexpr std::uint32_t to_stopped = 2U;

}  // namespace

static_assert(implements<req::CO_NMT_011>);
void Node::start_at(const Instant at) noexcept {
    wake();
    start_at_ = error_prevents_start() ? never : at;
}

bool Node::error_prevents_start() const noexcept {
    return communication_failed_ && (error_behaviour(communication_error_subindex) != no_change);
}

void Node::change_error(const ErrorId error, const bool present, const Instant now) noexcept {
    emcy_.set(error, present, now);
    wake();
}

static_assert(implements<req::CO_EMCY_016>);
void Node::set_overrun(const bool lost, const Instant now) noexcept {
    overrun_ = lost;
    set_error(ErrorId::can_overrun, lost, now);
}

void Node::set_controller(const std::uint8_t state, const bool overrun, const Instant now) noexcept {
    constexpr std::uint32_t worst = static_cast<std::uint8_t>(CanState::bus_off);
    set_can_state(static_cast<CanState>((state < worst) ? state : worst), now);
    set_overrun(overrun, now);
}

static_assert(implements<req::CO_EMCY_017>);
bool Node::may_send() const noexcept {
    return (can_state_ != CanState::bus_off) && !lss_.is_silent();
}

static_assert(implements<req::CO_EMCY_016> && implements<req::CO_EMCY_030> && implements<req::CO_EMCY_017>);
void Node::set_can_state(const CanState state, const Instant now) noexcept {
    if (state == can_state_) {
        return;
    }
    const bool was_off = can_state_ == CanState::bus_off;
    const bool is_off = state == CanState::bus_off;
    can_state_ = state;
    wake();
    if (may_send()) {
        queue_.open();
    } else {
        emcy_.take_back();
        queue_.close();
    }
    if (state_ == NmtState::initialising) {
        return;
    }
    if (is_off) {
        sdo_.abandon();
    }
    admit_services(now);
    if (was_off) {
        emcy_.report(ErrorId::bus_off_recovered, now);
    }
    emcy_.set(ErrorId::error_passive, state >= CanState::error_passive, now);
    watch_communication(now);
}

static_assert(implements<req::CO_PDO_032>);
Node::CommunicationFaults Node::communication_faults() const noexcept {
    return CommunicationFaults{heartbeats_.failed() |
                               (error_control_.life_guarding_failed() ? CommunicationFaults::guarding : 0U) |
                               (std::uint32_t{rpdos_.overdue()} << CommunicationFaults::first_rpdo_overdue) |
                               (rpdos_.has_short() ? CommunicationFaults::rpdo_short : 0U) |
                               (rpdos_.has_refused() ? CommunicationFaults::rpdo_refused : 0U) |
                               ((can_state_ == CanState::bus_off) ? CommunicationFaults::bus_off : 0U)};
}

static_assert(implements<req::CO_PDO_032>);
void Node::take_note(const Instant now) noexcept {
    const CommunicationFaults faults = communication_faults();
    if (faults.bits == faults_.bits) {
        return;
    }
    const CommunicationFaults begun{faults.bits & ~faults_.bits};
    static_assert(implements<req::CO_PDO_038>);
    const bool failed = faults.is_error();
    const bool changes = failed != communication_failed_;
    faults_ = faults;
    communication_failed_ = failed;
    announce(faults, now);
    // Each communication error changes the state as 1029h:1 (error behaviour) demands, also one that begins while
    // another lasts (CO-D-NMT-001).
    static_assert(implements<req::CO_NMT_007>);
    if (begun.is_error()) {
        apply_error_behaviour(communication_error_subindex, now);
    }
    if (changes) {
        application_.communication_failed(failed, now);
    }
}

static_assert(implements<req::CO_EMCY_016>);
void Node::announce(const CommunicationFaults faults, const Instant now) noexcept {
    using Faults = CommunicationFaults;
    emcy_.set(ErrorId::guard_or_heartbeat, faults.has(Faults::guarding | Faults::silent_producers), now);
    emcy_.set(ErrorId::life_guarding, faults.has(Faults::guarding), now);
    for (std::size_t slot = 0U; slot < HeartbeatConsumer::max_producers; ++slot) {
        const bool silent = faults.has(1U << slot);
        emcy_.set(error_after(ErrorId::heartbeat_1, slot), silent, now, heartbeats_.producer(slot));
    }
    emcy_.set(ErrorId::rpdo_length, faults.has(Faults::rpdo_short), now);
    emcy_.set(ErrorId::rpdo_value, faults.has(Faults::rpdo_refused), now);
    emcy_.set(ErrorId::rpdo_timeout, faults.has(Faults::rpdo_overdue), now);
}

/// Returns the value of 1029h:`subindex`; zero (to pre-operational) when the entry is absent.
std::uint32_t Node::error_behaviour(const std::uint8_t subindex) const noexcept {
    return objects_.read(index::error_behaviour, subindex);
}

static_assert(implements<req::CO_NMT_007> && implements<req::CO_NMT_010>);
void Node::apply_error_behaviour(const std::uint8_t subindex, const Instant now) noexcept {
    const std::uint32_t wanted = error_behaviour(subindex);
    if (wanted != no_change) {
        start_at_ = never;  // 1029h error behaviour has priority over the self-start
    }
    if ((wanted == to_pre_operational) && (state_ == NmtState::operational)) {
        enter(NmtState::pre_operational, now);
    } else if (wanted == to_stopped) {
        enter(NmtState::stopped, now);
    } else {
        // no change of state
    }
}

}  // namespace canproof
