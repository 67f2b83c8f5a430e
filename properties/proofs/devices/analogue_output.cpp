// SPDX-License-Identifier: Apache-2.0
// Theorems on the analogue outputs of the AX130751: in range whatever drives them, and in their fault state at once.
#include "devices/ax130751/firmware/analogue_output.hpp"

#include "generated/ax130751/requirements.hpp"
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

/// An output with any ramp in progress, and any inputs that are numbers.
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

void an_analogue_output_has_its_fault_value_at_once() {
    shows(
        "an output of the AX130751 has its fault value, nearest in its range, at once while an input in error drives "
        "it, and the override value while overridden, whatever ramp was in progress");
    proves<req::AOR_OUT_010, req::AOR_OUT_011, req::AOR_OUT_014>();
    AnyOutput any_output{};
    const bool fails = each(2U) == 0U;
    const AnalogueOutputState state =
        any_output.advance(fails ? OutputDrive::fault_value : OutputDrive::override_value);
    const double wanted = fails ? any_output.demand.fault_value : any_output.demand.override_value;
    claim(state.target == any_output.range.nearest(wanted));
    claim(any_output.output.ramp_.start_ == state.target);
    claim(state.value == state.target);
}

void an_analogue_output_is_off_in_a_shutdown() {
    shows("an output of the AX130751 whose range contains 0 or begins above it is 0 at once in a shutdown or shut-off");
    proves<req::AOR_OUT_014, req::AOR_OUT_015, req::AOR_DIAG_009>();
    AnyOutput any_output{};
    assume(any_output.range.maximum >= 0.0);
    const AnalogueOutputState state =
        any_output.advance((each(2U) == 0U) ? OutputDrive::shutdown : OutputDrive::shut_off);
    claim(state.target == 0.0);
    claim(state.value == 0.0);
}

void an_analogue_output_stays_in_its_range() {
    shows("an output of the AX130751 is 0 or within its range, whatever drives it and whatever ramp is in progress");
    proves<req::AOR_OUT_016>();
    AnyOutput any_output{};
    const AnalogueOutputState state = any_output.advance(static_cast<OutputDrive>(each(7U)));
    claim((state.value == 0.0) ||
          ((state.value >= any_output.range.minimum) && (state.value <= any_output.range.maximum)));
}

}  // namespace canproof::proofs
