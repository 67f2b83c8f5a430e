// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/relay.hpp"

#include "devices/ax130751/firmware/blinking.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

static_assert(implements<req::AOR_RELAY_009> && implements<req::AOR_RELAY_010> && implements<req::AOR_RELAY_011>);
bool Relay::advance(const OutputDrive drive, const RelayDemand& demand, const RelayPolarity& polarity,
                    const RelayTimes& times, const Instant now) noexcept {
    if (!was_valid_) {
        control_before_ = demand.control;  // a control signal that is valid again has no edge
    }
    was_valid_ = demand.is_valid;
    choose_polarity(polarity);
    watch_unlatch(demand.control, demand.unlatch);
    const bool controlled = drive == OutputDrive::control;
    const SwitchDrive answer = follow_control(demand, polarity, controlled);
    switch (drive) {
        case OutputDrive::control:
            static_assert(implements<req::AOR_RELAY_005>);
            // The delays apply to control and enable only: the unlatch input switches OFF at once.
            state_ = ((latch_ == Latch::unlatched) && (!memory_)) ? force(false) : follow(answer, times, now);
            break;
        case OutputDrive::override_value:
            state_ = force(demand.override_state);
            break;
        case OutputDrive::keep:
            static_assert(implements<req::AOR_RELAY_027>);
            state_ = force(state_);
            break;
        case OutputDrive::shut_off:
        case OutputDrive::ramp_off:
            state_ = follow(SwitchDrive::off, times, now);
            break;
        case OutputDrive::shutdown:
        case OutputDrive::fault_value:
        default:
            state_ = force(false);
            break;
    }
    control_before_ = demand.control;  // edges of the control signal are ignored while it does not drive the relay
    return state_;
}

/// Resets the latch to its rest state when a new polarity gives the unlatch input another effect.
void Relay::choose_polarity(const RelayPolarity& polarity) noexcept {
    if (polarity.unlatch != effect_) {
        effect_ = polarity.unlatch;
        latch_ = Latch::latching;
        memory_ = effect_ == UnlatchEffect::to_on;
    }
}

static_assert(implements<req::AOR_RELAY_007>);
void Relay::watch_unlatch(const bool control, const bool unlatch) noexcept {
    if (effect_ == UnlatchEffect::ignored) {
        return;
    }
    const bool rest = effect_ == UnlatchEffect::to_on;  // true: at rest, control signal and relay are both ON
    if (unlatch) {
        latch_ = Latch::unlatched;
        static_assert(implements<req::AOR_RELAY_006>);
        memory_ = rest;
    } else if (latch_ != Latch::latching) {
        static_assert(implements<req::AOR_RELAY_020>);
        static_assert(implements<req::AOR_RELAY_021>);
        latch_ = (control == rest) ? Latch::latching : Latch::waiting;
    } else {
        // the state of the latch stays `latching`
    }
}

static_assert(implements<req::AOR_RELAY_002> && implements<req::AOR_RELAY_003> && implements<req::AOR_RELAY_004>);
SwitchDrive Relay::follow_control(const RelayDemand& demand, const RelayPolarity& polarity,
                                  const bool counts) noexcept {
    const SwitchDrive answer = polarity.answer.drive(control_before_, demand.control);
    const bool of_latch = (answer == SwitchDrive::keep) || (answer == SwitchDrive::change);
    if (!of_latch) {
        return answer;
    }
    static_assert(implements<req::AOR_RELAY_017> && implements<req::AOR_RELAY_025>);
    if (counts && (latch_ == Latch::latching) && (answer == SwitchDrive::change)) {
        memory_ = !memory_;
    }
    return memory_ ? SwitchDrive::on : SwitchDrive::off;
}

static_assert(implements<req::AOR_RELAY_012> && implements<req::AOR_RELAY_013> && implements<req::AOR_RELAY_022>);
bool Relay::follow(const SwitchDrive drive, const RelayTimes& times, const Instant now) noexcept {
    const bool wanted = (drive == SwitchDrive::on) || (drive == SwitchDrive::blink);
    static_assert(implements<req::AOR_RELAY_023>);
    const bool on = delayed_.follow(wanted, times.on_delay, times.off_delay, now);
    // While a change to OFF is delayed, the relay stays ON or continues to blink, as it did before.
    static_assert(implements<req::AOR_RELAY_008> && implements<req::AOR_RELAY_015> && implements<req::AOR_RELAY_026>);
    const bool blinks = on && (wanted ? (drive == SwitchDrive::blink) : blinking_);
    if (!blinking_) {
        blinking_since_ = now;
    }
    blinking_ = blinks;
    next_blink_ = blinks ? next_blink(blinking_since_, times.blink, now) : never;
    return blinks ? blinks_on(blinking_since_, times.blink, now) : on;
}

static_assert(implements<req::AOR_RELAY_014>);
bool Relay::force(const bool state) noexcept {
    delayed_.set(state);
    blinking_ = false;
    next_blink_ = never;
    return state;
}

}  // namespace canproof::ax130751
