// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

static_assert(implements<req::AOR_T14>);
PointResponse point_response(const std::uint8_t value) noexcept {
    namespace table = own::point_response;
    return cell_or(table::find(value, table::Point::other), &table::Row::meaning, PointResponse::ignore);
}

/// Returns an interval in microseconds. A value below the shortest interval counts as the shortest: such a value can
/// remain from a time when the table was in data response. No value is above the longest interval.
double interval_us(const std::int32_t milliseconds_set) noexcept {
    const std::int32_t least{own::shortest_interval_ms};
    constexpr double us_per_ms = 1000.0;
    return static_cast<double>(std::max(milliseconds_set, least)) * us_per_ms;
}

static_assert(implements<req::AOR_LT_008> && implements<req::AOR_LT_023> && implements<req::AOR_LT_032>);
LookupConfig read_table(const ObjectDictionary& objects, const std::uint8_t number) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const bool timed = is_over_time(objects, number);
    const std::uint8_t x_digits = objects.get(fields.x_digits);
    LookupConfig config{};
    config.axis = timed ? LookupAxis::time : LookupAxis::data;
    config.repeat = objects.get(fields.repeat) != 0U;
    for (std::uint8_t point = 1U; point <= lookup_points; ++point) {
        const std::size_t at = point - std::size_t{1U};
        const std::int32_t x = objects.get(fields.x[point]);
        static_assert(implements<req::AOR_LT_038>);
        config.points.x[at] = timed ? interval_us(x) : physical_value(x, x_digits);
        config.points.response[at] = point_response(objects.get(fields.response[point]));
    }
    if (timed) {
        config.points = profile_of(config.points);
    }
    return config;
}

/// Returns the limits of a table's output for other blocks: 0 and 100 when all values of Y lie between them, otherwise
/// the least and the greatest Y.
static_assert(implements<req::AOR_LT_007> && implements<req::AOR_K_PERCENT_LOW> && implements<req::AOR_K_PERCENT_HIGH>);
LookupLimits limits_for_others(const LookupPoints& points) noexcept {
    const LookupLimits percent{static_cast<double>(own::percent_low), static_cast<double>(own::percent_high)};
    const LookupLimits limits = lookup_limits(points);
    const bool within = (limits.least >= percent.least) && (limits.greatest <= percent.greatest);
    return within ? percent : limits;
}

}  // namespace

bool is_over_time(const ObjectDictionary& objects, const std::uint8_t number) noexcept {
    namespace table = own::point_response;
    const std::uint8_t response = objects.get(lookup_fields[number - 1U].response[1U]);
    return cell_or(table::find(response, table::Point::first), &table::Row::meaning, table::Meaning::ignore) ==
           table::Meaning::time;
}

static_assert(implements<req::AOR_LT_014>);
void begin_time_response(ObjectDictionary& objects, const std::uint8_t number) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    objects.set(fields.x[1U], std::int32_t{0});
    objects.set(fields.y[1U], std::int16_t{0});
    objects.set(fields.x_digits, std::uint8_t{0U});
}

void TableBlock::reset(const std::uint8_t number, const ObjectDictionary& objects) noexcept {
    table_.reset();
    read(number, objects);
}

void TableBlock::read(const std::uint8_t number, const ObjectDictionary& objects) noexcept {
    config_ = read_table(objects, number);
    read_y(number, objects);
}

void TableBlock::read_y(const std::uint8_t number, const ObjectDictionary& objects) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const std::uint8_t digits = objects.get(fields.y_digits);
    for (std::uint8_t point = 1U; point <= lookup_points; ++point) {
        static_assert(implements<req::AOR_LT_039>);
        config_.points.y[point - 1U] = physical_value(objects.get(fields.y[point]), digits);
    }
    if (config_.axis == LookupAxis::time) {
        config_.points.y[0U] = 0.0;  // a profile starts at (0, 0): profile_of() sets the X to 0
    }
    limits_ = limits_for_others(config_.points);
}

void TableBlock::move_first_point(const std::uint8_t number, const ObjectDictionary& objects) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    // Over time, point 1 moves only to 0, which is its X already.
    config_.points.x[0U] = physical_value(objects.get(fields.x[1U]), objects.get(fields.x_digits));
}

bool TableBlock::advance(const std::uint8_t number, ObjectDictionary& objects, Sources& sources,
                         const Instant now) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const SourceRef& source = source_.follow(objects.get(fields.source), objects.get(fields.number));
    const BlockSignal input = sources.reading(source);
    const bool starts_by_limits = config_.axis == LookupAxis::time;
    const LookupOutput output = table_.advance(starts_by_limits ? sources.signal(source) : input, config_, now);
    const bool changes = output.state != state_;
    state_ = output.state;
    sources.set_lookup(number, output.state, limits_);
    return replace(objects, fields.output, process_value(output.value, objects.get(fields.y_digits))) || changes ||
           table_.is_running();
}

namespace {

static_assert(implements<req::AOR_LT_035>);
AbortCode check_range(const double value, const double least, const double greatest) noexcept {
    if (value > greatest) {
        return AbortCode::value_too_high;
    }
    return (value < least) ? AbortCode::value_too_low : AbortCode::none;
}

/// Checks the X of a point in data response (1.5.1): X must be between its neighbours and fit into 16 bits. If the
/// source has a value and two different limits, X must also be within these limits.
static_assert(implements<req::AOR_LT_009> && implements<req::AOR_LT_033> && implements<req::AOR_LT_034>);
AbortCode check_data_point(const ObjectDictionary& objects, const Sources& sources, const std::uint8_t number,
                           const std::uint8_t point, const std::int32_t x) noexcept {
    const LookupFields& fields = lookup_fields[number - 1U];
    const double least = (point > 1U)
                             ? static_cast<double>(objects.get(fields.x[static_cast<std::uint8_t>(point - 1U)]))
                             : static_cast<double>(INT16_MIN);
    const double greatest = (point < lookup_points)
                                ? static_cast<double>(objects.get(fields.x[static_cast<std::uint8_t>(point + 1U)]))
                                : static_cast<double>(INT16_MAX);
    const double value = static_cast<double>(x);
    // The X of a neighbour that was set as a time interval may be above the range of 16 bits, but not below it.
    const AbortCode by_order = check_range(value, least, std::fmin(greatest, static_cast<double>(INT16_MAX)));
    static_assert(implements<req::AOR_SRC_017>);
    const BlockSignal source = sources.signal(resolve(objects.get(fields.source), objects.get(fields.number)));
    if ((by_order != AbortCode::none) || (!source.is_available()) || (source.upper <= source.lower)) {
        return by_order;
    }
    return check_range(physical_value(x, objects.get(fields.x_digits)), source.lower, source.upper);
}

}  // namespace

static_assert(implements<req::AOR_LT_031>);
static_assert(implements<req::AOR_LT_024>);
AbortCode check_point(const ObjectDictionary& objects, const Sources& sources, const std::uint8_t number,
                      const std::uint8_t point, const std::int32_t x) noexcept {
    if (!is_over_time(objects, number)) {
        return check_data_point(objects, sources, number, point, x);
    }
    if (point == 1U) {
        return check_range(static_cast<double>(x), 0.0, 0.0);
    }
    static_assert(implements<req::AOR_K_SHORTEST_INTERVAL> && implements<req::AOR_K_LONGEST_INTERVAL>);
    static_assert(implements<req::AOR_LT_040>);
    return check_range(static_cast<double>(x), static_cast<double>(own::shortest_interval_ms),
                       static_cast<double>(own::longest_interval_ms));
}

bool SelectionBlock::advance(const std::uint8_t number, ObjectDictionary& objects, Sources& sources) noexcept {
    std::uint8_t selected{0U};
    BlockSignal table{};
    static_assert(implements<req::AOR_LOGIC_009>);
    if (objects.get(field::o3300_logic_block_enable[number])) {
        const std::size_t function =
            select_function([this, number, &objects, &sources](const std::size_t one) noexcept {
                return read(number, one, objects, sources);
            });
        static_assert(implements<req::AOR_LOGIC_006> && implements<req::AOR_T20>);
        selected = objects.get(logic_fields[number - 1U].tables[static_cast<std::uint8_t>(function + 1U)]);
        static_assert(implements<req::AOR_SRC_018>);
        table = sources.signal(SourceRef{Quantity::lookup_table, selected});
    }
    constexpr std::uint32_t tenths = 1U;
    static_assert(implements<req::AOR_LOGIC_007> && implements<req::AOR_LOGIC_008> && implements<req::AOR_LOGIC_013>);
    const double output = table.is_available() ? percentage_of_limits(table) : 0.0;
    static_assert(implements<req::AOR_LOGIC_014>);
    sources.set_logic(number, table.state);
    const bool reselects = std::uint32_t{objects.get(field::o3310_logic_block_selected_table[number])} != selected;
    objects.set(field::o3310_logic_block_selected_table[number], selected);
    objects.set(field::o3320_logic_block_output_pv[number], process_value(output, tenths));
    return reselects;
}

LogicFunction SelectionBlock::read(const std::uint8_t number, const std::size_t function,
                                   const ObjectDictionary& objects, const Sources& sources) noexcept {
    const LogicFields& fields = logic_fields[number - 1U];
    LogicFunction made{};
    made.logical = objects.get(fields.operators[static_cast<std::uint8_t>(function + 1U)]);
    for (std::size_t condition = 0U; condition < logic_conditions; ++condition) {
        const std::size_t at = (function * logic_conditions) + condition;
        const ConditionFields& of = fields.conditions[at];
        const SourceRef& first = choices_[at].first.follow(objects.get(of.first_source), objects.get(of.first_number));
        const SourceRef& second =
            choices_[at].second.follow(objects.get(of.second_source), objects.get(of.second_number));
        LogicCondition& at_place = made.conditions[condition];
        at_place.first = sources.reading(first);
        at_place.second = sources.reading(second);
        at_place.comparison = objects.get(of.comparison);
    }
    return made;
}

static_assert(implements<req::AOR_MATH_009> && implements<req::AOR_MATH_010> && implements<req::AOR_K_GAIN_ONE>);
void CalculationBlock::read(const std::uint8_t number, const std::uint8_t input, const ObjectDictionary& objects,
                            const Sources& sources, MathInput& made) noexcept {
    const MathFields& fields = math_fields[number - 1U];
    Input& kept = inputs_[input - 1U];
    const SourceRef& ref = kept.choice.follow(objects.get(fields.source[input]), objects.get(fields.number[input]));
    const std::int8_t gain = objects.get(fields.gain[input]);
    if (std::int32_t{gain} != kept.gain_parameter) {
        kept.gain_parameter = gain;
        kept.gain = quotient(static_cast<double>(gain), static_cast<double>(own::gain_of_one));
    }
    const bool own_block = (ref.quantity == Quantity::math) && (std::uint32_t{ref.channel} == number);
    const std::uint8_t digits = objects.get(fields.digits[input]);
    made.signal = sources.reading(ref);
    static_assert(implements<req::AOR_MATH_020>);
    made.scaling_1 = kept.scaling_1.of(objects.get(fields.scaling_1[input]), digits);
    made.scaling_2 = kept.scaling_2.of(objects.get(fields.scaling_2[input]), digits);
    made.gain = kept.gain;
    made.own_function = own_block ? objects.get(fields.function[input]) : std::uint8_t{0U};
}

static_assert(implements<req::AOR_MATH_008> && implements<req::AOR_MATH_011>);
bool CalculationBlock::advance(const std::uint8_t number, ObjectDictionary& objects, const Sources& sources) noexcept {
    MathResult result{};
    if (objects.get(field::o4000_math_function_enable[number])) {
        MathConfig config{};
        for (std::uint8_t input = 1U; input <= math_inputs; ++input) {
            read(number, input, objects, sources, config.inputs[input - 1U]);
        }
        for (std::uint8_t function = 1U; function <= math_functions; ++function) {
            config.operators[function - 1U] = objects.get(math_fields[number - 1U].operators[function]);
        }
        result = math_.advance(config);
    } else {
        math_.reset();
    }
    static_assert(implements<req::AOR_MATH_025>);
    const std::uint8_t digits = objects.get(field::o4032_math_output_decimal_digits_pv[number]);
    double output{0.0};
    if (result.done) {
        output = math_output(result.value,
                             output_scaling_1_.of(objects.get(field::o4021_math_output_scaling_1_pv[number]), digits),
                             output_scaling_2_.of(objects.get(field::o4023_math_output_scaling_2_pv[number]), digits));
    }
    objects.set(field::o4030_math_output_process_value[number], process_value(output, digits));
    return !math_.is_settled();
}

}  // namespace canproof::ax130751
