#include "devices/ax130751/firmware/ax130751_first_point.hpp"

#include "devices/ax130751/firmware/ax130751_blocks.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

constexpr std::uint32_t digits_fv_index = 0x6332U;
constexpr std::uint32_t digits_pv_index = 0x6302U;
constexpr std::uint32_t output_type_index = 0x6310U;
constexpr std::uint32_t over_temperature_index = 0x5032U;
constexpr std::uint32_t cooling_index = 0x5033U;
constexpr std::uint32_t scaling_1_fv_index = 0x7321U;
constexpr std::uint32_t scaling_1_pv_index = 0x7320U;
constexpr std::uint32_t scaling_2_fv_index = 0x7323U;
constexpr std::uint32_t scaling_2_pv_index = 0x7322U;
constexpr std::uint32_t extra_digits_index = 0x2502U;
constexpr std::uint32_t extra_scaling_1_index = 0x2520U;
constexpr std::uint32_t extra_scaling_2_index = 0x2522U;
constexpr std::uint32_t math_digits_index = 0x4032U;
constexpr std::uint32_t math_scaling_1_index = 0x4021U;
constexpr std::uint32_t math_scaling_2_index = 0x4023U;

/// Whether a write to `entry` may have given a source another minimum (Table 5). Other sources are never below 0.
bool moves_minimum(const EntryRef& entry, const SourceRef& ref) noexcept {
    const std::uint32_t index = entry.index;
    const bool of_channel = std::uint32_t{entry.row->subindex} == ref.channel;
    switch (ref.quantity) {
        case Quantity::output_command:
            return of_channel && ((index == scaling_1_pv_index) || (index == scaling_2_pv_index) ||
                                  (index == digits_pv_index) || (index == output_type_index));
        case Quantity::commanded_value:
        case Quantity::feedback_value:
            return of_channel && ((index == scaling_1_fv_index) || (index == scaling_2_fv_index) ||
                                  (index == digits_fv_index) || (index == output_type_index));
        case Quantity::extra_received:
            return of_channel && ((index == extra_scaling_1_index) || (index == extra_scaling_2_index) ||
                                  (index == extra_digits_index));
        case Quantity::math:
            return of_channel &&
                   ((index == math_scaling_1_index) || (index == math_scaling_2_index) || (index == math_digits_index));
        case Quantity::lookup_table:
            return std::uint32_t{table_entry(entry.index).table} == ref.channel;
        case Quantity::temperature:
            return (index == over_temperature_index) || (index == cooling_index);
        default:
            return false;
    }
}

/// The least Y of a table, ignored points included (1.5.2); point 1 of one over time counts as 0.
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
    const bool moves = is_ours && (wanted != x_) && (wanted <= objects.get(fields.x[2U]));
    if (moves) {
        objects.set(fields.x[1U], wanted);
    }
    if (moves || (!is_ours)) {
        x_ = wanted;
    }
    return moves;
}

/// The minimum in the digits of X, the nearest that does not lie below it; 0 where it is not below 0, and over time.
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
