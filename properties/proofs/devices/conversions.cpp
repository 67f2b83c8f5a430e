// SPDX-License-Identifier: Apache-2.0
// Theorems on conversions between numbers on the bus and physical values: for any value, the result is within its
// range, and the conversion is monotone.
#include "devices/ax060805/firmware/angle_range.hpp"
#include "devices/ax060805/firmware/count_value.hpp"
#include "devices/ax188001/firmware/process_value.hpp"
#include "devices/cbx-ao412/firmware/voltage_output.hpp"
#include "generated/ax060805/requirements.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/cbx_ao412/constants.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

using cbx_ao412::OutputCalibration;
using cbx_ao412::VoltageOutputCircuit;

constexpr std::int32_t largest_step = 4095;  // CAN-CBX-AO412, 4.3.1: 12 bits and sign

VoltageOutputCircuit circuit() {
    namespace own = generated::cbx_ao412;
    return {own::reference_voltage * (own::feedback_resistor / own::input_resistor), own::dac_steps,
            own::codes_per_step};
}

/// Returns the step of an output with the calibration as shipped.
std::int32_t shipped_step(const std::int16_t value) {
    return cbx_ao412::output_step(value, circuit(), OutputCalibration{});
}

}  // namespace

void an_output_step_is_within_its_converter() {
    shows("an output of the CAN-CBX-AO412 stays within -4095…4095 steps for any value and any numbers as calibration");
    proves<req::AO4_AOUT_003>();
    const OutputCalibration calibration{any<float>(), any<float>()};
    const std::int32_t step = cbx_ao412::output_step(any<std::int16_t>(), circuit(), calibration);
    claim((step >= -largest_step) && (step <= largest_step));
}

void an_output_step_is_rounded_to_nearest() {
    shows("without calibration a value gives the step floor((value + 4) / 8), at most 4095 in size, and is monotone");
    proves<req::AO4_AOUT_002>();
    const auto value = any<std::int16_t>();
    const std::int32_t rounded = (std::int32_t{value} + 4 + 65536) / 8 - 8192;
    const std::int32_t least = (rounded < -largest_step) ? -largest_step : rounded;
    claim(shipped_step(value) == ((least > largest_step) ? largest_step : least));
}

void a_count_saturates() {
    shows(
        "with one count a unit and without offset a field value of the AX060805 is the nearer end of INTEGER16 when "
        "its value is outside of it, and 0 when it is NaN");
    proves<req::INC_FV_002>();
    const auto value = any<float>();
    const std::int16_t count = ax060805::count_value(value, {});
    claim(!(value >= 32767.0F) || (count == 32767));
    claim(!(value <= -32768.0F) || (count == -32768));
    claim((value <= value) || (count == 0));
}

void a_count_is_defined_for_any_scale() {
    shows("a field value of the AX060805 has a result for any value, digits and offset, also for no number");
    proves<req::INC_FV_002>();
    const ax060805::CountScale scale{any<std::uint16_t>(), any<float>()};
    static_cast<void>(ax060805::count_value(any<float>(), scale));
}

void a_count_is_monotone() {
    shows("with one count a unit and without offset a field value of the AX060805 is monotone in its value");
    proves<req::INC_FV_001>();
    const auto a = any<float>();
    const auto b = any<float>();
    assume(a <= b);
    claim(ax060805::count_value(a, {}) <= ax060805::count_value(b, {}));
}

void whole_milliseconds_are_monotone() {
    shows("a time in whole milliseconds is monotone in its value, and 0 for a negative one and for no number");
    const auto a = any<float>();
    const auto b = any<float>();
    claim((a > 0.0F) || (ax060805::whole_milliseconds(a) == 0U));
    claim(!(a <= b) || (ax060805::whole_milliseconds(a) <= ax060805::whole_milliseconds(b)));
}

void an_angle_is_within_its_span() {
    shows("an angle of -180…180 degrees is within -180…180, 0…360 (without 360) or 0…90 in each of these spans");
    proves<req::INC_RANGE_001, req::INC_RANGE_004, req::INC_RANGE_005>();
    const std::array<ax060805::AngleSpan, 3U> spans{{{-180, 180}, {0, 360}, {0, 90}}};
    const std::size_t which = each(3U);
    const ax060805::AngleSpan& span = spans[which];
    const auto degrees = any<float>();
    assume((degrees >= -180.0F) && (degrees <= 180.0F));
    const float shown = ax060805::in_span(degrees, span);
    claim((shown >= static_cast<float>(span.lower)) && (shown <= static_cast<float>(span.upper)));
    claim((which != 1U) || (shown < 360.0F));
    claim((which != 0U) || (shown == degrees));
}

void a_process_value_saturates() {
    shows(
        "a process value of the AX188001 is the nearer end of INTEGER16 when the scaled value is outside of it, for "
        "any value, factor and offset; no number gives -32768");
    proves<req::TCS_VAL_004>();
    const auto value = any<double>();
    const ax188001::Scaling scaling{any<double>(), any<double>()};
    const std::int16_t shown = ax188001::process_value(value, scaling);
    const double scaled = (value * scaling.factor) + scaling.offset;
    claim(!(scaled >= 32767.0) || (shown == 32767));
    claim(!(scaled <= -32768.0) || (shown == -32768));
    claim((scaled <= scaled) || (shown == -32768));
}

void a_process_value_is_monotone() {
    shows("with the factor 1 and without offset a process value of the AX188001 is monotone in its field value");
    proves<req::TCS_VAL_001>();
    const auto a = any<double>();
    const auto b = any<double>();
    assume(a <= b);
    claim(ax188001::process_value(a, {}) <= ax188001::process_value(b, {}));
}

void a_measurement_is_no_reserved_value() {
    shows(
        "a measured process value of the AX188001 is never FFFFh (disabled) or FE00h (open), for any value and "
        "scaling");
    proves<req::TCS_VAL_007>();
    const ax188001::Scaling scaling{any<double>(), any<double>()};
    const std::int16_t shown = ax188001::measured_process_value(any<double>(), scaling, {-1, -512});
    claim((shown != -1) && (shown != -512));
}

}  // namespace canproof::proofs
