// SPDX-License-Identifier: Apache-2.0
#include "target/zynqmp/can_controller.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::zynqmp {

namespace {

constexpr std::uint32_t first_filter = bit(0U);  // UAF1 of AFR

}  // namespace

/// Resets the controller, which also drops the frame in the transmit buffer: configuration mode alone would keep it
/// (UG1085, "TX Messages"), and it would be sent at the new rate.
static_assert(implements<req::CO_ZCAN_001> && implements<req::CO_ZCAN_002> && implements<req::CO_ZCAN_003>);
void CanController::set_bit_rate(const std::uint32_t bit_rate, const Instant now) noexcept {
    static_assert(implements<req::CO_ZCAN_013>);
    bit_rate_ = bit_rate;
    if (state_of(registers_.status.read()) == CanState::bus_off) {
        state_ = CanState::bus_off;
        rests_until_ = now + bus_off_rest;
    }
    reset(now);
    const Result<BitTiming, BitTimingError> found = bit_timing(clock_hz_, bit_rate);
    if (found.ok()) {
        timing_ = found.value();
    } else {
        phase_ = Phase::off;
        state_ = CanState::bus_off;
    }
}

void CanController::reset(const Instant now) noexcept {
    registers_.software_reset.write(srr::reset);
    begin(Phase::resetting, now);
}

void CanController::begin(const Phase phase, const Instant now) noexcept {
    phase_ = phase;
    since_ = now;
}

/// Takes the next step when the hardware is ready for it. A filter may be written only while it is not used and ACFBSY
/// is 0, so the previous step ends the use of the filter.
static_assert(implements<req::CO_ZCAN_005>);
void CanController::advance(const Instant now) noexcept {
    const std::uint32_t status = registers_.status.read();
    bool goes_on{true};
    switch (phase_) {
        case Phase::resetting:
            goes_on = (status & sr::configuration) != 0U;
            if (goes_on) {
                registers_.filters_used.write(0U);
                begin(Phase::filtering, now);
            }
            break;
        case Phase::filtering:
            goes_on = (status & sr::filters_busy) == 0U;
            if (goes_on && (rests_until_ <= now)) {
                configure();
                begin(Phase::joining, now);
            }
            break;
        case Phase::joining:
            goes_on = (status & sr::normal) != 0U;
            if (goes_on) {
                begin(Phase::on_bus, now);
                state_ = state_of(status);
            }
            break;
        case Phase::on_bus:
            state_ = state_of(status);
            break;
        case Phase::off:
        default:
            break;  // the controller does nothing until the next bit rate is set
    }
    if (!goes_on) {
        give_up_waiting(now);
    }
}

/// Handles hardware that does not take its next step: resets it again and reports bus-off. Only a controller that waits
/// for an idle bus is left alone, because it joins when the bus is idle.
static_assert(implements<req::CO_ZCAN_004> && implements<req::CO_ZCAN_011>);
void CanController::give_up_waiting(const Instant now) noexcept {
    if (elapsed(since_, now).us < most_wait.us) {
        return;
    }
    state_ = CanState::bus_off;
    if (phase_ != Phase::joining) {
        reset(now);
    }
}

/// Writes bit timing and filter, which is possible in configuration mode only, and then leaves this mode. One filter
/// compares IDE only: every 11-bit identifier passes, because the dictionary can change at any time which of them the
/// node uses.
static_assert(implements<req::CO_ZCAN_001> && implements<req::CO_ZCAN_006>);
void CanController::configure() noexcept {
    registers_.prescaler.write(prescaler_register(timing_));
    registers_.bit_timing.write(segments_register(timing_));
    registers_.filters[0U].mask.write(idr::extended);
    registers_.filters[0U].identifier.write(0U);
    registers_.filters_used.write(first_filter);
    registers_.mode.write(0U);  // 0 is the normal mode: no loop-back, sleep or snoop mode
    registers_.software_reset.write(srr::enable);
}

/// Returns the state that the controller shows. In its recovery from bus-off, the controller itself counts 128 times 11
/// recessive bits; it shows bus-off until the count is complete.
static_assert(implements<req::CO_ZCAN_007>);
CanState CanController::state_of(const std::uint32_t status) noexcept {
    if ((status & sr::error_state) == sr::bus_off) {
        return CanState::bus_off;
    }
    if ((status & sr::error_state) == sr::error_passive) {
        return CanState::error_passive;
    }
    return ((status & sr::warning) != 0U) ? CanState::warning : CanState::error_active;
}

}  // namespace canproof::zynqmp
