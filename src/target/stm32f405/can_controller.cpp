// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/can_controller.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

/// Mode of operation: the lowest identifier is sent first, a full FIFO keeps its oldest frames, every frame has a time
/// stamp, lost arbitration and errors are retried. Only set_bit_rate() and watch_bus() leave bus-off.
constexpr std::uint32_t operation = mcr::lock_fifo | mcr::time_stamps;

/// The highest bit of an 11-bit identifier, at its place in a filter bank. This bit selects the FIFO.
constexpr std::uint32_t upper_half = 0x400U << ir::standard_shift;
constexpr std::uint32_t both_banks = 0x3U;
constexpr std::uint32_t second_bank = 0x2U;

}  // namespace

static_assert(implements<req::CO_CAN_001> && implements<req::CO_CAN_009>);
void CanController::set_bit_rate(const std::uint32_t bit_rate, const Instant now) noexcept {
    bit_rate_ = bit_rate;
    const Result<BitTiming, BitTimingError> found = bit_timing(clock_hz_, bit_rate);
    if (found.ok()) {
        timing_ = found.value();
        enter(now);
    } else {
        registers_.master_control.write(operation | mcr::initialise);
        phase_ = Phase::off;
        state_ = CanState::bus_off;
    }
}

void CanController::enter(const Instant now) noexcept {
    registers_.master_control.write(operation | mcr::initialise);
    phase_ = Phase::entering;
    since_ = now;
}

static_assert(implements<req::CO_CAN_011>);
void CanController::advance(const Instant now) noexcept {
    const bool initialising = registers_.master_status.has(msr::initialising);
    switch (phase_) {
        case Phase::entering:
            if (!initialising) {
                give_up_waiting(now);
            } else if (may_recover(now)) {
                leave(now);
            } else {
                state_ = CanState::bus_off;  // a new bit rate waits for the end of the pause
            }
            break;
        case Phase::leaving:
            if (!initialising) {
                phase_ = Phase::on_bus;
                state_ = read_state();
            } else {
                give_up_waiting(now);
            }
            break;
        case Phase::on_bus:
            watch_bus(now);
            break;
        case Phase::off:
        default:
            break;  // the controller stays off the bus until the next call of set_bit_rate()
    }
}

/// Handles a missing acknowledgement of the hardware. A controller that does not enter initialisation is reset as a
/// whole (RM0090 32.9.2, CAN_MCR.RESET). A controller that cannot join the bus, because the bus is never recessive long
/// enough, continues to wait.
static_assert(implements<req::CO_CAN_002> && implements<req::CO_CAN_010>);
void CanController::give_up_waiting(const Instant now) noexcept {
    if (elapsed(since_, now).us < most_wait.us) {
        return;
    }
    state_ = CanState::bus_off;
    if (phase_ == Phase::entering) {
        registers_.master_control.write(mcr::reset);
        enter(now);
    }
}

/// Writes bit timing and filters, and aborts the frames of the last configuration. Must be called in initialisation
/// mode, because CAN_BTR can be written only in this mode.
void CanController::configure() noexcept {
    registers_.bit_timing.write(bit_timing_register(timing_));
    set_filters();
    registers_.transmit_status.write(tsr::abort | (tsr::abort << tsr::stride) | (tsr::abort << (2U * tsr::stride)));
}

/// Sets the filters. Identifiers below 400h (NMT, SYNC, EMCY, most PDOs) go to FIFO 0. Those from 400h on (SDO, error
/// control, LSS) go to FIFO 1, so that all six places of the two FIFOs are used. A mask over IDE rejects 29-bit
/// identifiers. All 11-bit identifiers pass, because the dictionary can change at any time which of them the node uses.
static_assert(implements<req::CO_CAN_003>);
void CanController::set_filters() noexcept {
    registers_.filter_master.set(filter_initialise);
    registers_.filter_active.write(0U);
    registers_.filter_mode.write(0U);  // identifier and mask
    registers_.filter_scale.write(both_banks);
    registers_.filter_fifo.write(second_bank);
    registers_.filter_bank[0U].identifier.write(0U);
    registers_.filter_bank[0U].mask.write(upper_half | ir::extended);
    registers_.filter_bank[1U].identifier.write(upper_half);
    registers_.filter_bank[1U].mask.write(upper_half | ir::extended);
    registers_.filter_active.write(both_banks);
    registers_.filter_master.clear(filter_initialise);
}

/// Leaves initialisation mode. In bus-off this begins the recovery (RM0090 32.7.6).
void CanController::leave(const Instant now) noexcept {
    configure();
    registers_.master_control.write(operation);
    phase_ = Phase::leaving;
    since_ = now;
    if (recovery_ == Recovery::resting) {
        recovery_ = Recovery::counting;
    }
}

static_assert(implements<req::CO_CAN_007> && implements<req::CO_CAN_015>);
void CanController::watch_bus(const Instant now) noexcept {
    state_ = read_state();
    const bool may_begin = may_recover(now);
    if ((recovery_ == Recovery::resting) && may_begin) {
        enter(now);
    }
}

/// Notes when the controller becomes bus-off. Returns whether leaving initialisation mode may now begin a recovery: not
/// during the pause.
static_assert(implements<req::CO_CAN_008> && implements<req::CO_CAN_016> && implements<req::CO_CAN_017>);
bool CanController::may_recover(const Instant now) noexcept {
    if (read_state() != CanState::bus_off) {
        recovery_ = Recovery::none;
    } else if (recovery_ == Recovery::none) {
        recovery_ = Recovery::resting;
        off_since_ = now;
    } else {
        // the bus-off state goes on
    }
    return (recovery_ != Recovery::resting) || (elapsed(off_since_, now).us >= bus_off_rest.us);
}

CanState CanController::read_state() const noexcept {
    const std::uint32_t status = registers_.error_status.read();
    if ((status & esr::bus_off) != 0U) {
        return CanState::bus_off;
    }
    if ((status & esr::passive) != 0U) {
        return CanState::error_passive;
    }
    return ((status & esr::warning) != 0U) ? CanState::warning : CanState::error_active;
}

}  // namespace canproof::stm32f405
