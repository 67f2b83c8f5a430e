// SPDX-License-Identifier: Apache-2.0
// Theorems on the analogue outputs of the AX130751: an output stays within its range, whatever input determines it, and
// takes its fault state at once.
#include "devices/ax130751/firmware/analogue_output.hpp"

#include "devices/ax130751/firmware/quotient.hpp"
#include "generated/ax130751/requirements.hpp"
#include "properties/proofs/support/contract.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

using ax130751::AnalogueOutput;
using ax130751::AnalogueOutputState;
using ax130751::OutputDrive;
using ax130751::OutputRange;
using ax130751::RampTimes;

constexpr double greatest = 1.0e9;  ///< greater than each value and each span of the device

double any_number() {
    const auto number = any<double>();
    assume((number >= -greatest) && (number <= greatest));
    return number;
}

/// An output in the middle of any ramp, with any inputs that are no NaN.
struct AnyOutput {
    AnalogueOutput output{};
    OutputRange range{any_number(), any_number()};
    ax130751::AnalogueDemand demand{any_number(), any_number(), any_number()};
    RampTimes times{any_number(), any<Duration>(), any<Duration>()};
    Instant now{any<Instant>()};

    AnyOutput() {
        output.ramp_.start_ = any_number();
        output.ramp_.target_ = any_number();
        output.ramp_.since_ = any<Instant>();
        output.ramp_.times_ = RampTimes{any_number(), any<Duration>(), any<Duration>()};
        assume(range.minimum <= range.maximum);
    }
    AnalogueOutputState advance(const OutputDrive drive) { return output.advance(drive, demand, range, times, now); }
};

}  // namespace

void an_analogue_output_turns_to_its_fault_value_at_once() {
    shows(
        "an output of the AX130751 has its fault value, nearest in its range, as its target, and no ramp is left, "
        "while "
        "an input in error drives it; the same holds for the override value while overridden");
    proves<req::AOR_OUT_010, req::AOR_OUT_011, req::AOR_OUT_014>();
    AnyOutput any_output{};
    const bool fails = each(2U) == 0U;
    const AnalogueOutputState state =
        any_output.advance(fails ? OutputDrive::fault_value : OutputDrive::override_value);
    const double wanted = fails ? any_output.demand.fault_value : any_output.demand.override_value;
    claim(state.target == any_output.range.nearest(wanted));
    claim((any_output.output.ramp_.start_ == state.target) && (any_output.output.ramp_.target_ == state.target));
}

void an_analogue_output_turns_off_in_a_shutdown() {
    shows("an output of the AX130751 has the target 0, and no ramp is left, in a shutdown or shut-off");
    proves<req::AOR_OUT_014, req::AOR_OUT_015, req::AOR_DIAG_020>();
    AnyOutput any_output{};
    const AnalogueOutputState state =
        any_output.advance((each(2U) == 0U) ? OutputDrive::shutdown : OutputDrive::shut_off);
    claim(state.target == 0.0);
    claim((any_output.output.ramp_.start_ == 0.0) && (any_output.output.ramp_.target_ == 0.0));
}

void a_ramp_without_a_way_stays_at_its_target() {
    shows("a ramp of the AX130751 that was set to a number has this number as its value at any time");
    proves<req::AOR_OUT_014>();
    ax130751::Ramp ramp{};
    ramp.since_ = any<Instant>();
    ramp.times_ = RampTimes{any_number(), any<Duration>(), any<Duration>()};
    const double value = any_number();
    ramp.set(value);
    claim(ramp.value_at(any<Instant>()) == value);
}

void a_quotient_of_any_numbers_is_computed() {
    shows("the division of the AX130751 has no undefined behaviour for any two doubles; 0 divided by a number is 0");
    const auto dividend = any<double>();
    const auto divisor = any<double>();
    const double found = ax130751::quotient(dividend, divisor);
    claim((dividend != 0.0) || (divisor != divisor) || (found == 0.0));
}

/// Contract of quotient(): any number, also NaN.
double quotient_by_contract(const double /*dividend*/, const double /*divisor*/) noexcept {
    return any<double>();
}

void an_analogue_output_stays_in_its_range() {
    shows("an output of the AX130751 is 0 or within its range, whatever drives it and whatever ramp is in progress");
    proves<req::AOR_OUT_016>();
    use_contract("ax130751::quotient", "a_quotient_of_any_numbers_is_computed", quotient_by_contract);
    AnyOutput any_output{};
    const AnalogueOutputState state = any_output.advance(static_cast<OutputDrive>(each(7U)));
    claim((state.value == 0.0) ||
          ((state.value >= any_output.range.minimum) && (state.value <= any_output.range.maximum)));
}

}  // namespace canproof::proofs
