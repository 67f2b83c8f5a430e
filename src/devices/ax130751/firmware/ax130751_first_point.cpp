// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_first_point.hpp"

#include "devices/ax130751/firmware/ax130751_blocks.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

/// Returns whether a write may have moved point 1 of table `number`, whose source is `ref`: a write to the table
/// itself, or to what sets the minimum of the source (Table 5). A write to the X, the digits of X or the repetition
/// moves only the point of its own table, because no minimum depends on them. A quantity without a case in the switch
/// below never has a minimum below 0.
bool moves_point(const own::Written& change, const std::uint8_t number, const SourceRef& ref) noexcept {
    using own::Parameter;
    const bool of_channel = std::uint32_t{change.subindex} == ref.channel;
    const bool of_field_value =
        of_channel && ((ref.quantity == Quantity::commanded_value) || (ref.quantity == Quantity::feedback_value));
    const bool of_command = of_channel && (ref.quantity == Quantity::output_command);
    switch (change.parameter) {
        case Parameter::lt_input_x_axis_source:
        case Parameter::lt_input_x_axis_number:
        case Parameter::lt_auto_repeat:
        case Parameter::lt_x_axis_decimal_digits_pv:
        case Parameter::lt_point_x_axis_pv:
            return std::uint32_t{change.member} == number;
        case Parameter::lt_y_axis_decimal_digits_pv:
        case Parameter::lt_point_response:
        case Parameter::lt_point_y_axis_pv:
            return (std::uint32_t{change.member} == number) ||
                   ((ref.quantity == Quantity::lookup_table) && (std::uint32_t{change.member} == ref.channel));
        case Parameter::ao_output_type:
            return of_command || of_field_value;
        case Parameter::ao_decimal_digits_pv:
        case Parameter::ao_output_scaling_1_pv:
        case Parameter::ao_output_scaling_2_pv:
            return of_command;
        case Parameter::ao_decimal_digits_fv:
        case Parameter::ao_output_scaling_1_fv:
        case Parameter::ao_output_scaling_2_fv:
            return of_field_value;
        case Parameter::ec_decimal_digits_pv:
        case Parameter::ec_scaling_1_pv:
        case Parameter::ec_scaling_2_pv:
            return of_channel && (ref.quantity == Quantity::extra_received);
        case Parameter::math_output_decimal_digits_pv:
        case Parameter::math_output_scaling_1_pv:
        case Parameter::math_output_scaling_2_pv:
            return of_channel && (ref.quantity == Quantity::math);
        case Parameter::over_temperature_threshold:
        case Parameter::hysteresis_to_clear_temperature_fault:
            return ref.quantity == Quantity::temperature;
        case Parameter::ao_override_field_value:
        case Parameter::ao_fault_field_value:
        default:  // no other parameter exists: -Wswitch-enum demands a label for each parameter
            return false;
    }
}

/// Returns the least Y of a table, including ignored points (1.5.2). With time response, the Y of point 1 counts as 0.
double least_y(const ObjectDictionary& objects, const std::uint8_t number) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    std::int16_t least = is_over_time(objects, number) ? std::int16_t{0} : objects.get(fields.y[1U]);
    for (std::uint8_t point = 2U; point <= lookup_points; ++point) {
        const std::int16_t y = objects.get(fields.y[point]);
        least = (y < least) ? y : least;
    }
    return physical_value(least, objects.get(fields.y_digits));
}

}  // namespace

void FirstPoint::begin(const std::uint8_t number, const ObjectDictionary& objects, const Sources& sources,
                       LastMinimum& last) noexcept {
    x_ = place_of(number, objects, sources, last);
}

std::int32_t LastMinimum::place(const std::uint8_t digits_of_x) noexcept {
    if ((!is_placed) || (std::uint32_t{digits_of_x} != digits)) {
        is_placed = true;
        digits = digits_of_x;
        const std::int32_t nearest = process_value(value, digits);
        x = (physical_value(nearest, digits) < value) ? (nearest + 1) : nearest;
    }
    return x;
}

static_assert(implements<req::AOR_LT_017> && implements<req::AOR_LT_018>);
bool FirstPoint::follow(const std::uint8_t number, const own::Written& change, ObjectDictionary& objects,
                        const Sources& sources, LastMinimum& last) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const SourceRef& ref = source_.follow(objects.get(fields.source), objects.get(fields.number));
    if (!moves_point(change, number, ref)) {
        return false;
    }
    const std::int32_t wanted = place_of(number, objects, sources, last);
    const bool is_ours = objects.get(fields.x[1U]) == x_;
    static_assert(implements<req::AOR_LT_027> && implements<req::AOR_LT_028>);
    const bool moves = is_ours && (wanted != x_) && (wanted <= objects.get(fields.x[2U]));
    if (moves) {
        objects.set(fields.x[1U], wanted);
    }
    if (moves || (!is_ours)) {
        x_ = wanted;
    }
    return moves;
}

/// Returns the position of point 1: the minimum of the source with the decimal digits of X, rounded so that it is not
/// below the minimum. Returns 0 when the minimum is not below 0, for a time response, and without a source.
std::int32_t FirstPoint::place_of(const std::uint8_t number, const ObjectDictionary& objects, const Sources& sources,
                                  LastMinimum& last) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const SourceRef& ref = source_.follow(objects.get(fields.source), objects.get(fields.number));
    if ((ref.quantity == Quantity::none) || is_over_time(objects, number)) {
        return 0;
    }
    if ((ref.quantity != last.ref.quantity) || (std::uint32_t{ref.channel} != last.ref.channel)) {
        const bool of_table = ref.quantity == Quantity::lookup_table;
        last = LastMinimum{};
        last.ref = ref;
        last.value = of_table ? least_y(objects, ref.channel) : sources.minimum(ref);
    }
    const double minimum = last.value;
    if (minimum >= 0.0) {
        return 0;
    }
    return last.place(objects.get(fields.x_digits));
}

}  // namespace canproof::ax130751
