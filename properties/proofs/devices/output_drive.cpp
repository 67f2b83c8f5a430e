// SPDX-License-Identifier: Apache-2.0
// Theorems on the outputs of the AX130751: which condition determines them, and that they are in their fault state
// while a fault determines them.
#include "devices/ax130751/firmware/digital_output.hpp"
#include "devices/ax130751/firmware/output_priority.hpp"
#include "generated/ax130751/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

using ax130751::DigitalOutput;
using ax130751::DigitalOutputState;
using ax130751::OutputConditions;
using ax130751::OutputDrive;

/// A digital output in any state, with any inputs.
struct AnyOutput {
    DigitalOutput output{};
    ax130751::DigitalDemand demand{any<ax130751::DigitalDemand>()};
    ax130751::SwitchPolarity polarity{any<ax130751::SwitchPolarity>()};
    Duration blink{any<std::uint64_t>()};
    Instant now{any<Instant>()};

    AnyOutput() { leave_open(output); }
    DigitalOutputState advance(const OutputDrive drive) { return output.advance(drive, demand, polarity, blink, now); }
};

}  // namespace

void the_first_condition_drives_an_output() {
    shows(
        "of a shutdown, an override, a disabling enable input and an input in error the first one that is present "
        "drives an output; the control drives it only when none is present");
    proves<req::AOR_OUT_007>();
    auto conditions = any<OutputConditions>();
    const std::array<OutputDrive, 4U> by_enable{OutputDrive::control, OutputDrive::shut_off, OutputDrive::ramp_off,
                                                OutputDrive::keep};  // the enable responses of Tables 7 and 11
    conditions.enable = by_enable[each(4U)];
    conditions.on_error = (each(2U) == 0U) ? OutputDrive::keep : OutputDrive::fault_value;  // Tables 2 and 9
    const OutputDrive drive = ax130751::choose_drive(conditions);
    const bool runs = conditions.enable == OutputDrive::control;
    const bool is_free = !conditions.shutdown && !conditions.overridden;
    claim((drive == OutputDrive::shutdown) == conditions.shutdown);
    claim((drive == OutputDrive::override_value) == (!conditions.shutdown && conditions.overridden));
    claim((drive == OutputDrive::control) == (is_free && runs && !conditions.input_in_error));
    const bool keeps = conditions.on_error == OutputDrive::keep;
    const bool fails = is_free && runs && conditions.input_in_error;
    claim((drive == OutputDrive::fault_value) == (fails && !keeps));
    claim((drive == OutputDrive::keep) ==
          (is_free && (runs ? (fails && keeps) : (conditions.enable == OutputDrive::keep))));
}

void a_digital_output_is_off_in_a_shutdown() {
    shows("a digital output is OFF at once while a shutdown, a shut-off or a ramp to OFF drives it, in any state");
    proves<req::AOR_DO_011, req::AOR_OUT_015>();
    AnyOutput any_output{};
    const std::array<OutputDrive, 3U> off{OutputDrive::shutdown, OutputDrive::shut_off, OutputDrive::ramp_off};
    const DigitalOutputState state = any_output.advance(off[each(3U)]);
    claim(!state.logic && !state.drive);
    claim(any_output.output.next_change() == never);
}

void a_digital_output_has_its_fault_state() {
    shows(
        "a digital output has its fault state while an input in error drives it, and its override state while "
        "overridden");
    proves<req::AOR_DO_006>();
    AnyOutput any_output{};
    const bool fails = each(2U) == 0U;
    const DigitalOutputState state = any_output.advance(fails ? OutputDrive::fault_value : OutputDrive::override_value);
    const bool expected = fails ? any_output.demand.fault_state : any_output.demand.override_state;
    claim((state.logic == expected) && (state.drive == expected));
    claim(any_output.output.next_change() == never);
}

void a_latched_output_keeps_its_latch() {
    shows("the latched state of a digital output changes only while its control drives it");
    proves<req::AOR_DO_008, req::AOR_DO_013>();
    AnyOutput any_output{};
    const bool before = any_output.output.memory_;
    const auto drive = any<OutputDrive>();
    assume(drive != OutputDrive::control);
    static_cast<void>(any_output.advance(drive));
    claim(any_output.output.memory_ == before);
    claim(any_output.output.control_before_ == any_output.demand.control);
}

}  // namespace canproof::proofs
