// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_output.hpp"

#include <cmath>

#include "devices/ax130751/firmware/current_loop.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

static_assert(implements<req::AOR_T07> && implements<req::AOR_E_OUTPUT_DRIVE>);
OutputDrive enable_drive(const std::uint8_t response, const bool on) noexcept {
    namespace table = own::enable_response;
    return cell_or(table::find(response, on), &table::Row::drive, OutputDrive::shut_off);
}

static_assert(implements<req::AOR_T01>);
SwitchDrive switch_drive(const std::uint8_t value, const bool before, const bool state) noexcept {
    namespace table = own::digital_polarity;
    return cell_or(table::find(value, before, state), &table::Row::drive, SwitchDrive::off);
}

static_assert(implements<req::AOR_T06> && implements<req::AOR_OUT_006> && implements<req::AOR_OUT_031>);
bool follows_profile(const std::uint8_t response, const ScalingPosition position) noexcept {
    namespace table = own::control_response;
    return cell_or(table::find(response, position), &table::Row::drive, table::Drive::off) == table::Drive::profile;
}

/// Returns whether the override input is active, as the manual's Table 8 defines it.
static_assert(implements<req::AOR_T08>);
bool is_overridden(const std::uint8_t response, const bool on) noexcept {
    return cell_or(own::override_response::find(response, on), &own::override_response::Row::overridden, false);
}

OutputRange range_of(const own::output_type::Row& type) noexcept {
    return OutputRange{static_cast<double>(type.minimum), static_cast<double>(type.maximum)};
}

}  // namespace

void UniversalOutput::reset() noexcept {
    analogue_.reset();
    digital_.reset();
    control_ = DigitalReading{};
    enable_ = DigitalReading{};
    override_ = DigitalReading{};
    type_ = objects_.get(field::o6310_ao_output_type[number_]);
}

static_assert(implements<req::AOR_OUT_023>);
bool UniversalOutput::follow_type() noexcept {
    if (std::uint32_t{objects_.get(field::o6310_ao_output_type[number_])} == type_) {
        return false;
    }
    reset();
    constexpr std::int16_t off = 0;
    static_assert(implements<req::AOR_OUT_050>);
    return show(off, off);  // must precede the reading of the inputs, because an input may be the value of this output
}

bool UniversalOutput::advance(const OutputCycle& cycle, const Inputs& inputs, Outputs& outputs) noexcept {
    const bool was_cleared = follow_type();
    const InputSignals signals = read_inputs();
    clear(outputs);
    const bool changes = is_digital(objects_, number_) ? advance_digital(signals, cycle, outputs)
                                                       : advance_analogue(signals, cycle, inputs, outputs);
    return changes || was_cleared;
}

UniversalOutput::InputSignals UniversalOutput::read_inputs() noexcept {
    const InputSignals signals{
        sources_.signal(control_choice_.follow(objects_.get(field::o2340_ao_control_input_source[number_]),
                                               objects_.get(field::o2341_ao_control_input_number[number_]))),
        sources_.signal(enable_choice_.follow(objects_.get(field::o2350_ao_enable_input_source[number_]),
                                              objects_.get(field::o2351_ao_enable_input_number[number_]))),
        sources_.signal(override_choice_.follow(objects_.get(field::o2360_ao_override_input_source[number_]),
                                                objects_.get(field::o2361_ao_override_input_number[number_])))};
    static_cast<void>(control_.read(signals.control));
    static_cast<void>(enable_.read(signals.enable));
    static_cast<void>(override_.read(signals.override_input));
    return signals;
}

static_assert(implements<req::AOR_T02> && implements<req::AOR_T09> && implements<req::AOR_E_OUTPUT_DRIVE>);
OutputDrive UniversalOutput::error_drive(const bool digital) const noexcept {
    if (digital) {
        namespace table = own::digital_error_response;
        const std::uint8_t mode = objects_.get(field::o6250_do_fault_mode_1_output_line[number_]);
        return cell_or(table::find(mode), &table::Row::drive, OutputDrive::fault_value);
    }
    namespace table = own::analogue_error_response;
    const std::uint8_t mode = objects_.get(field::o6340_ao_fault_mode[number_]);
    return cell_or(table::find(mode), &table::Row::drive, OutputDrive::fault_value);
}

static_assert(implements<req::AOR_OUT_028> && implements<req::AOR_OUT_029> && implements<req::AOR_OUT_033>);
OutputDrive UniversalOutput::drive_of(const InputSignals& signals, const bool shutdown, const bool digital) noexcept {
    OutputConditions conditions{};
    conditions.shutdown = shutdown || sources_.lacks(enable_choice_, signals.enable) ||
                          sources_.lacks(override_choice_, signals.override_input);
    conditions.input_in_error =
        signals.control.is_in_error() || signals.enable.is_in_error() || signals.override_input.is_in_error();
    conditions.on_error = error_drive(digital);
    static_assert(implements<req::AOR_OUT_008>);
    conditions.overridden = signals.override_input.is_valid() &&
                            is_overridden(objects_.get(field::o2362_ao_override_response[number_]), override_.on());
    conditions.enable = signals.enable.is_valid()
                            ? enable_drive(objects_.get(field::o2352_ao_enable_response[number_]), enable_.on())
                            : OutputDrive::control;
    const bool runs = (conditions.enable == OutputDrive::control) && (!conditions.input_in_error);
    if (runs && (!signals.control.is_available())) {
        static_assert(implements<req::AOR_OUT_032>);
        // Without a control signal the output is OFF at once, whatever its ramps and its polarity.
        conditions.enable = OutputDrive::shut_off;
    }
    return choose_drive(conditions);
}

static_assert(implements<req::AOR_OUT_005>);
LinearScaling UniversalOutput::scaling() noexcept {
    const std::uint8_t pv_digits = objects_.get(field::o6302_ao_decimal_digits_pv[number_]);
    const std::uint8_t fv_digits = objects_.get(field::o6332_ao_decimal_digits_fv[number_]);
    return LinearScaling{
        parameters_.scaling_1_pv.of(objects_.get(field::o7320_ao_output_scaling_1_pv[number_]), pv_digits),
        parameters_.scaling_2_pv.of(objects_.get(field::o7322_ao_output_scaling_2_pv[number_]), pv_digits),
        parameters_.scaling_1_fv.of(objects_.get(field::o7321_ao_output_scaling_1_fv[number_]), fv_digits),
        parameters_.scaling_2_fv.of(objects_.get(field::o7323_ao_output_scaling_2_fv[number_]), fv_digits)};
}

AnalogueDemand UniversalOutput::demand(const double control) noexcept {
    const std::uint8_t digits = objects_.get(field::o6332_ao_decimal_digits_fv[number_]);
    return AnalogueDemand{
        control, parameters_.override_fv.of(objects_.get(field::o2300_ao_override_field_value[number_]), digits),
        parameters_.fault_fv.of(objects_.get(field::o7341_ao_fault_field_value[number_]), digits)};
}

static_assert(implements<req::AOR_OUT_003> && implements<req::AOR_OUT_004>);
double UniversalOutput::control_value(const BlockSignal& control, const LinearScaling& scaling) const noexcept {
    const std::uint8_t response = objects_.get(field::o2342_ao_control_response[number_]);
    const bool driven = follows_profile(response, position_of(control.value, scaling));
    return driven ? scale(control.value, scaling) : 0.0;
}

/// Returns the value at the terminals: a current is limited by the load; a duty cycle is 0 when the frequency is 0.
double UniversalOutput::carried(const Kind kind, const double value, const Inputs& inputs) const noexcept {
    if (kind == Kind::current) {
        return loop_current(value, static_cast<double>(inputs.load[number_ - 1U]),
                            static_cast<double>(own::compliance_voltage),
                            static_cast<double>(own::milliamperes_per_ampere));
    }
    const bool stands = (kind == Kind::pwm) && (objects_.get(field::o2380_ao_output_frequency[number_]) == 0U);
    return stands ? 0.0 : value;
}

static_assert(implements<req::AOR_OUT_025> && implements<req::AOR_SPEC_001> && implements<req::AOR_OUT_049>);
bool UniversalOutput::advance_analogue(const InputSignals& signals, const OutputCycle& cycle, const Inputs& inputs,
                                       Outputs& outputs) noexcept {
    const own::output_type::Row& type = output_type(objects_, number_);
    const LinearScaling line = scaling();
    const AnalogueDemand demanded = demand(control_value(signals.control, line));
    const RampTimes times{std::fabs(line.y2 - line.y1), milliseconds(objects_.get(field::o2330_ao_ramp_up[number_])),
                          milliseconds(objects_.get(field::o2331_ao_ramp_down[number_]))};
    const OutputDrive drive = drive_of(signals, cycle.shutdown, false);
    const AnalogueOutputState state = analogue_.advance(drive, demanded, range_of(type), times, cycle.now);
    const double value = carried(type.kind, state.value, inputs);
    const std::uint8_t fv_digits = objects_.get(field::o6332_ao_decimal_digits_fv[number_]);
    static_assert(implements<req::AOR_OUT_017> && implements<req::AOR_OUT_018> && implements<req::AOR_OUT_044>);
    const bool changes = show(process_value(state.target, fv_digits), process_value(value, fv_digits));
    static_assert(implements<req::AOR_SPEC_002>);
    drive_analogue(type.kind, value, outputs);
    return analogue_.is_moving(cycle.now) || changes;
}

void UniversalOutput::clear(Outputs& outputs) const noexcept {
    const std::size_t at = number_ - 1U;
    outputs.out_voltage[at] = 0.0F;
    outputs.out_current[at] = 0.0F;
    outputs.out_duty[at] = 0.0F;
    outputs.out_frequency[at] = 0.0F;
    outputs.out_level[at] = 0.0F;
    outputs.out_on[at] = false;
}

static_assert(implements<req::AOR_OUT_019> && implements<req::AOR_OUT_021> && implements<req::AOR_OUT_036>);
void UniversalOutput::drive_analogue(const Kind kind, const double value, Outputs& outputs) const noexcept {
    const std::size_t at = number_ - 1U;
    switch (kind) {
        case Kind::voltage:
            outputs.out_voltage[at] = static_cast<float>(value);
            break;
        case Kind::current:
            outputs.out_current[at] = static_cast<float>(value);
            break;
        case Kind::pwm:
            static_assert(implements<req::AOR_OUT_047>);
            outputs.out_duty[at] = static_cast<float>(value);
            static_assert(implements<req::AOR_OUT_020>);
            outputs.out_frequency[at] = static_cast<float>(objects_.get(field::o2380_ao_output_frequency[number_]));
            outputs.out_level[at] = static_cast<float>(level());
            break;
        case Kind::frequency:
            static_assert(implements<req::AOR_OUT_046>);
            outputs.out_duty[at] = (value > 0.0) ? own::frequency_duty : 0.0F;
            static_assert(implements<req::AOR_OUT_035>);
            outputs.out_frequency[at] = static_cast<float>(value);
            outputs.out_level[at] = static_cast<float>(level());
            break;
        case Kind::none:
        case Kind::digital:
        default:
            break;
    }
}

static_assert(implements<req::AOR_T_DIGITAL_RANGE> && implements<req::AOR_OUT_048>);
double UniversalOutput::level() const noexcept {
    namespace table = own::digital_range;
    const std::uint8_t range = objects_.get(field::o2240_do_digital_range[number_]);
    return static_cast<double>(cell_or(table::find(range), &table::Row::level_v, 0.0F));
}

static_assert(implements<req::AOR_DO_018>);
SwitchPolarity UniversalOutput::polarity() const noexcept {
    const std::uint8_t value = objects_.get(field::o2241_do_polarity_1_output_line[number_]);
    SwitchPolarity made{};
    made.was_off = {{switch_drive(value, false, false), switch_drive(value, false, true)}};
    made.was_on = {{switch_drive(value, true, false), switch_drive(value, true, true)}};
    return made;
}

static_assert(implements<req::AOR_DO_002> && implements<req::AOR_DO_007> && implements<req::AOR_DO_017>);
bool UniversalOutput::advance_digital(const InputSignals& signals, const OutputCycle& cycle,
                                      Outputs& outputs) noexcept {
    const DigitalDemand demand{control_.on(), objects_.get(field::o2300_ao_override_field_value[number_]) != 0,
                               objects_.get(field::o6260_do_fault_state_1_output_line[number_]),
                               signals.control.is_valid()};
    const OutputDrive drive = drive_of(signals, cycle.shutdown, true);
    const Duration blink = milliseconds(objects_.get(field::o2223_do_blink_rate_1_output_line[number_]));
    const DigitalOutputState state = digital_.advance(drive, demand, polarity(), blink, cycle.now);
    const std::size_t at = number_ - 1U;
    outputs.out_on[at] = state.drive;
    outputs.out_level[at] = static_cast<float>(level());
    outputs.out_voltage[at] = state.drive ? outputs.out_level[at] : 0.0F;
    return show(static_cast<std::int16_t>(state.logic ? 1 : 0), static_cast<std::int16_t>(state.drive ? 1 : 0));
}

bool UniversalOutput::show(const std::int16_t target, const std::int16_t feedback) noexcept {
    const bool changes = replace(objects_, field::o7330_ao_output_field_value[number_], target);
    return replace(objects_, field::o2370_ao_feedback_field_value[number_], feedback) || changes;
}

static_assert(implements<req::AOR_OUT_022> && implements<req::AOR_OUT_037> && implements<req::AOR_T_TYPE_DEFAULTS>);
void UniversalOutput::take_type_defaults() noexcept {
    const auto type = static_cast<own::OutputType>(objects_.get(field::o6310_ao_output_type[number_]));
    const auto* const row = own::type_defaults::find(type);
    static_assert(implements<req::AOR_OUT_038>);
    const bool updates = objects_.get(field::o5550_enable_automatic_updates) != 0U;
    if ((row == nullptr) || (type == own::OutputType::not_used) || (!updates)) {
        return;
    }
    constexpr std::int16_t off = 0;
    objects_.set(field::o6302_ao_decimal_digits_pv[number_], row->digits);
    objects_.set(field::o6332_ao_decimal_digits_fv[number_], row->digits);
    objects_.set(field::o7320_ao_output_scaling_1_pv[number_], row->scaling_1);
    objects_.set(field::o7322_ao_output_scaling_2_pv[number_], row->scaling_2);
    objects_.set(field::o7321_ao_output_scaling_1_fv[number_], row->scaling_1);
    objects_.set(field::o7323_ao_output_scaling_2_fv[number_], row->scaling_2);
    objects_.set(field::o2300_ao_override_field_value[number_], off);
    objects_.set(field::o7341_ao_fault_field_value[number_], off);
}

static_assert(implements<req::AOR_OUT_024> && implements<req::AOR_OUT_039> && implements<req::AOR_OUT_040>);
AbortCode UniversalOutput::check_field_value(const std::int16_t field_value) const noexcept {
    const own::output_type::Row& type = output_type(objects_, number_);
    static_assert(implements<req::AOR_OUT_051>);
    if ((type.kind == Kind::none) || (field_value == 0)) {
        return AbortCode::none;
    }
    static_assert(implements<req::AOR_OUT_052>);
    const double value = physical_value(field_value, objects_.get(field::o6332_ao_decimal_digits_fv[number_]));
    const OutputRange range = range_of(type);
    if (value > range.maximum) {
        return AbortCode::value_too_high;
    }
    return (value < range.minimum) ? AbortCode::value_too_low : AbortCode::none;
}

}  // namespace canproof::ax130751
