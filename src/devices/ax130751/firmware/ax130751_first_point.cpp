// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_first_point.hpp"

#include "devices/ax130751/firmware/ax130751_blocks.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/index.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace index = generated::ax130751::index;

/// Returns whether a write to `entry` may have changed the minimum of the source `ref` (Table 5). Quantities without a
/// case below have no minimum below 0.
bool moves_minimum(const EntryRef& entry, const SourceRef& ref) noexcept {
    const std::uint32_t index = entry.index;
    const bool of_channel = std::uint32_t{entry.row->subindex} == ref.channel;
    switch (ref.quantity) {
        case Quantity::output_command:
            return of_channel &&
                   ((index == index::ao_output_scaling_1_pv) || (index == index::ao_output_scaling_2_pv) ||
                    (index == index::ao_decimal_digits_pv) || (index == index::ao_output_type));
        case Quantity::commanded_value:
        case Quantity::feedback_value:
            return of_channel &&
                   ((index == index::ao_output_scaling_1_fv) || (index == index::ao_output_scaling_2_fv) ||
                    (index == index::ao_decimal_digits_fv) || (index == index::ao_output_type));
        case Quantity::extra_received:
            return of_channel && ((index == index::ec_scaling_1_pv) || (index == index::ec_scaling_2_pv) ||
                                  (index == index::ec_decimal_digits_pv));
        case Quantity::math:
            return of_channel &&
                   ((index == index::math_output_scaling_1_pv) || (index == index::math_output_scaling_2_pv) ||
                    (index == index::math_output_decimal_digits_pv));
        case Quantity::lookup_table:
            return std::uint32_t{table_entry(entry.index).table} == ref.channel;
        case Quantity::temperature:
            return (index == index::over_temperature_threshold) ||
                   (index == index::hysteresis_to_clear_temperature_fault);
        default:
            return false;
    }
}

/// Returns the least Y of a table, including ignored points (1.5.2). Point 1 of a table with time response counts as 0.
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

void FirstPoint::begin(const std::uint8_t number, const ObjectDictionary& objects, const Sources& sources) noexcept {
    x_ = place_of(number, objects, sources);
}

static_assert(implements<req::AOR_LT_017> && implements<req::AOR_LT_018>);
bool FirstPoint::follow(const std::uint8_t number, const EntryRef& entry, ObjectDictionary& objects,
                        const Sources& sources) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const bool own = std::uint32_t{table_entry(entry.index).table} == number;
    const SourceRef& ref = source_.follow(objects.get(fields.source), objects.get(fields.number));
    if ((!own) && (!moves_minimum(entry, ref))) {
        return false;
    }
    const std::int32_t wanted = place_of(number, objects, sources);
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

/// Returns the position of point 1: the minimum of the source in the digits of X, rounded so that it is not below the
/// minimum. Returns 0 when the minimum is not below 0, for a time response, and without a source.
std::int32_t FirstPoint::place_of(const std::uint8_t number, const ObjectDictionary& objects,
                                  const Sources& sources) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const SourceRef& ref = source_.follow(objects.get(fields.source), objects.get(fields.number));
    if ((ref.quantity == Quantity::none) || is_over_time(objects, number)) {
        return 0;
    }
    const bool of_table = ref.quantity == Quantity::lookup_table;
    const double minimum = of_table ? least_y(objects, ref.channel) : sources.minimum(ref);
    if (minimum >= 0.0) {
        return 0;
    }
    const std::uint8_t digits = objects.get(fields.x_digits);
    const std::int32_t nearest = process_value(minimum, digits);
    return (physical_value(nearest, digits) < minimum) ? (nearest + 1) : nearest;
}

}  // namespace canproof::ax130751
