// SPDX-License-Identifier: Apache-2.0
// Checks new values of parameters and applies their effects.

#include "devices/ax130751/firmware/ax130751.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

std::int16_t to_int16(const ByteView value) noexcept {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(read_le(value, 0U, sizeof(std::int16_t))));
}

std::int32_t to_int32(const ByteView value) noexcept {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(read_le(value, 0U, sizeof(std::int32_t))));
}

}  // namespace

AbortCode Device::before_write(const EntryRef& entry, const ByteView value) {
    using own::Parameter;
    const own::Written change = own::written(entry.index, entry.row->subindex);
    switch (change.parameter) {
        case Parameter::lt_point_x_axis_pv:
            return check_point(objects_, sources_, change.member, change.subindex, to_int32(value));
        case Parameter::ao_override_field_value:
        case Parameter::ao_output_scaling_1_fv:
        case Parameter::ao_output_scaling_2_fv:
        case Parameter::ao_fault_field_value:
            return universal_[change.subindex - 1U].check_field_value(to_int16(value));
        case Parameter::lt_input_x_axis_source:
        case Parameter::lt_input_x_axis_number:
        case Parameter::lt_auto_repeat:
        case Parameter::lt_x_axis_decimal_digits_pv:
        case Parameter::lt_y_axis_decimal_digits_pv:
        case Parameter::lt_point_response:
        case Parameter::lt_point_y_axis_pv:
        case Parameter::ec_decimal_digits_pv:
        case Parameter::ec_scaling_1_pv:
        case Parameter::ec_scaling_2_pv:
        case Parameter::math_output_scaling_1_pv:
        case Parameter::math_output_scaling_2_pv:
        case Parameter::math_output_decimal_digits_pv:
        case Parameter::over_temperature_threshold:
        case Parameter::hysteresis_to_clear_temperature_fault:
        case Parameter::ao_decimal_digits_pv:
        case Parameter::ao_output_type:
        case Parameter::ao_decimal_digits_fv:
        case Parameter::ao_output_scaling_1_pv:
        case Parameter::ao_output_scaling_2_pv:
        default:  // no other parameter exists: -Wswitch-enum demands a label for each parameter
            return AbortCode::none;
    }
}

static_assert(implements<req::AOR_LT_018>);
void Device::after_write(const EntryRef& entry, const Instant) {
    using own::Parameter;
    const own::Written change = own::written(entry.index, entry.row->subindex);
    switch (change.parameter) {
        case Parameter::lt_point_response:
            if ((change.subindex == 1U) && is_over_time(objects_, change.member)) {
                begin_time_response(objects_, change.member);
            }
            tables_[change.member - 1U].read(change.member, objects_);
            break;
        case Parameter::lt_auto_repeat:
        case Parameter::lt_x_axis_decimal_digits_pv:
        case Parameter::lt_point_x_axis_pv:
            tables_[change.member - 1U].read(change.member, objects_);
            break;
        case Parameter::lt_y_axis_decimal_digits_pv:
        case Parameter::lt_point_y_axis_pv:
            tables_[change.member - 1U].read_y(change.member, objects_);
            break;
        case Parameter::ao_output_type:
            take_type(change.subindex);
            break;
        case Parameter::lt_input_x_axis_source:
        case Parameter::lt_input_x_axis_number:
        case Parameter::ao_override_field_value:
        case Parameter::ec_decimal_digits_pv:
        case Parameter::ec_scaling_1_pv:
        case Parameter::ec_scaling_2_pv:
        case Parameter::math_output_scaling_1_pv:
        case Parameter::math_output_scaling_2_pv:
        case Parameter::math_output_decimal_digits_pv:
        case Parameter::over_temperature_threshold:
        case Parameter::hysteresis_to_clear_temperature_fault:
        case Parameter::ao_decimal_digits_pv:
        case Parameter::ao_decimal_digits_fv:
        case Parameter::ao_output_scaling_1_pv:
        case Parameter::ao_output_scaling_1_fv:
        case Parameter::ao_output_scaling_2_pv:
        case Parameter::ao_output_scaling_2_fv:
        case Parameter::ao_fault_field_value:
            break;  // each cycle reads these objects; follow_minima() below handles a changed minimum of a source
        default:
            break;  // no other parameter exists: -Wswitch-enum demands a label for each parameter
    }
    follow_minima(change);
}

static_assert(implements<req::AOR_OUT_022>);
void Device::take_type(const std::uint8_t output) noexcept {
    const std::uint16_t type = objects_.get(field::o6310_ao_output_type[output]);
    if (std::uint32_t{type} != types_[output - 1U]) {
        types_[output - 1U] = type;
        universal_[output - 1U].take_type_defaults();
    }
}

/// Moves point 1 of each lookup table whose source has another minimum after a write. Need not run in each cycle,
/// because the minimum of a source depends only on parameters.
void Device::follow_minima(const own::Written& change) noexcept {
    LastMinimum last{};
    for (std::uint8_t table = 1U; table <= table_count; ++table) {
        if (first_points_[table - 1U].follow(table, change, objects_, sources_, last)) {
            tables_[table - 1U].move_first_point(table, objects_);
        }
    }
}

}  // namespace canproof::ax130751
