// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/digital_output.hpp"

#include "devices/ax130751/firmware/blinking.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

static_assert(implements<req::AOR_DO_005> && implements<req::AOR_DO_008>);
DigitalOutputState DigitalOutput::advance(const OutputDrive drive, const DigitalDemand& demand,
                                          const SwitchPolarity& polarity, const Duration blink,
                                          const Instant now) noexcept {
    if (!was_valid_) {
        control_before_ = demand.control;  // a control signal that is valid again has no edge
    }
    was_valid_ = demand.is_valid;
    static_assert(implements<req::AOR_DO_015> && implements<req::AOR_DO_016>);
    switch (drive) {
        case OutputDrive::control:
            state_.logic = demand.control;
            static_assert(implements<req::AOR_DO_012> && implements<req::AOR_DO_021>);
            state_.drive = follow_control(polarity.drive(control_before_, demand.control), blink, now);
            break;
        case OutputDrive::override_value:
            static_assert(implements<req::AOR_DO_006>);
            state_ = DigitalOutputState{demand.override_state, demand.override_state};
            break;
        case OutputDrive::fault_value:
            state_ = DigitalOutputState{demand.fault_state, demand.fault_state};
            break;
        case OutputDrive::keep:
            break;
        case OutputDrive::shutdown:
        case OutputDrive::shut_off:
        case OutputDrive::ramp_off:
        default:
            static_assert(implements<req::AOR_DO_011>);
            state_ = DigitalOutputState{};
            break;
    }
    if (drive != OutputDrive::control) {
        blinking_ = false;  // the next blinking starts with ON
        next_blink_ = never;
    }
    static_assert(implements<req::AOR_DO_013>);
    control_before_ = demand.control;  // edges of the control signal are ignored while it does not drive the output
    return state_;
}

static_assert(implements<req::AOR_DO_003> && implements<req::AOR_DO_004> && implements<req::AOR_DO_010>);
bool DigitalOutput::follow_control(const SwitchDrive drive, const Duration blink, const Instant now) noexcept {
    const bool blinks = drive == SwitchDrive::blink;
    if (!blinking_) {
        blinking_since_ = now;
    }
    blinking_ = blinks;
    next_blink_ = blinks ? next_blink(blinking_since_, blink, now) : never;
    switch (drive) {
        case SwitchDrive::on:
            memory_ = true;
            break;
        case SwitchDrive::change:
            static_assert(implements<req::AOR_DO_019>);
            memory_ = !memory_;
            break;
        case SwitchDrive::blink:
            static_assert(implements<req::AOR_DO_014> && implements<req::AOR_DO_020>);
            memory_ = blinks_on(blinking_since_, blink, now);
            break;
        case SwitchDrive::keep:
            break;
        case SwitchDrive::off:
        case SwitchDrive::none:
        default:
            memory_ = false;
            break;
    }
    return memory_;
}

}  // namespace canproof::ax130751
