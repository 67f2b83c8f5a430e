// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_sources.hpp"

#include <algorithm>

#include "firmware/base/requirement.hpp"
#include "firmware/base/slots.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/index.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;
namespace index = generated::ax130751::index;

/// Returns the limits of a quantity; nullptr for a number that is no quantity. Each input of a block needs a row in
/// each cycle, so this function does not search it: row number n of the limits belongs to quantity n.
const own::value_limits::Row* limits_of(const Quantity quantity) noexcept {
    const auto number = static_cast<std::size_t>(quantity);
    return (number < own::value_limits::rows.size()) ? &own::value_limits::rows[number] : nullptr;
}

constexpr std::size_t source_count{10U};  ///< sources of Table 4A
using FirstRows = std::array<std::uint8_t, source_count + 1U>;

/// Returns the number of the first row of Table 4B for each source, and behind the last source the number of rows.
constexpr FirstRows first_rows() noexcept {
    FirstRows first{};
    std::uint8_t number{0U};
    for (const own::control_number::Row& row : own::control_number::rows) {
        ++number;
        first[row.source + 1U] = number;
    }
    return first;
}
const FirstRows first_row_of = first_rows();

/// Returns the row of Table 4B for a source and a number; nullptr, or a row without a quantity, when they select none.
/// After a power-on the sources of all inputs are looked up in one cycle, so this function does not search. The rows of
/// a source begin with the numbers from 1 on. Any row behind them serves for 0 and higher numbers: these have no
/// quantity. Source 0, supply and temperature have one row for all numbers.
const own::control_number::Row* choice_of(const std::uint32_t source, const std::uint32_t number) noexcept {
    if ((source + 1U) >= first_row_of.size()) {
        return nullptr;
    }
    const std::uint32_t first{first_row_of[source]};
    const std::uint32_t last = first_row_of[source + 1U] - 1U;
    return &own::control_number::rows[(number == 0U) ? last : std::min((first + number) - 1U, last)];
}

/// Returns the state of a measured value: NaN is an error of the measurement.
static_assert(implements<req::AOR_SRC_019>);
SignalState measured_state(const float measured) noexcept {
    return std::isnan(measured) ? SignalState::error : SignalState::valid;
}

}  // namespace

static_assert(implements<req::AOR_T03> && implements<req::AOR_E_OUTPUT_TYPE>);
const own::output_type::Row& output_type(const ObjectDictionary& objects, const std::uint8_t output) noexcept {
    const std::uint16_t type = objects.get(field::o6310_ao_output_type[output]);
    const auto* const row = own::output_type::find(static_cast<own::OutputType>(type));
    return (row == nullptr) ? own::output_type::rows[0U] : *row;
}

static_assert(implements<req::AOR_DO_001> && implements<req::AOR_DO_009> && implements<req::AOR_DO_022>);
bool is_digital(const ObjectDictionary& objects, const std::uint8_t output) noexcept {
    return output_type(objects, output).kind == own::output_type::Kind::digital;
}

static_assert(implements<req::AOR_T4A> && implements<req::AOR_T4B> && implements<req::AOR_SRC_001>);
SourceRef resolve(const std::uint8_t source, const std::uint8_t number) noexcept {
    namespace table = own::control_number;
    const table::Row* const row = choice_of(source, number);
    static_assert(implements<req::AOR_SRC_011>);
    return SourceRef{cell_or(row, &table::Row::quantity, Quantity::none),
                     cell_or(row, &table::Row::channel, std::uint8_t{0U})};
}

void Sources::reset() noexcept {
    lookup_states_.fill(SignalState::not_available);
    logic_states_.fill(SignalState::not_available);
}

static_assert(implements<req::AOR_SRC_004>);
void Sources::set_network(const std::uint8_t overdue, const bool silent) noexcept {
    overdue_ = OverdueEntries{};
    silent_ = silent;
    std::uint32_t left{overdue};
    for (const MappingFields& mapping : rpdo_mappings) {
        if ((left & 1U) != 0U) {
            add_overdue(mapping);
        }
        left >>= 1U;
    }
}

/// Adds to the set of overdue entries those that an overdue RPDO maps.
void Sources::add_overdue(const MappingFields& mapping) noexcept {
    const Slots<const Field<std::uint32_t>> entries{mapping.entries.data(), mapping.entries.size()};
    const std::size_t count{objects_.get(mapping.count)};
    for (const Field<std::uint32_t>& line : entries.part(0U, count)) {
        const std::uint32_t entry = objects_.get(line) >> 8U;
        const std::uint32_t bit = std::uint32_t{1U} << (entry & 0x1FU);
        switch (entry >> 8U) {
            case index::ao_output_process_value:
                overdue_.commands |= bit;
                break;
            case index::do_write_state_1_output_line:
                overdue_.states |= bit;
                break;
            case index::ec_extra_received_process_value:
                overdue_.extra |= bit;
                break;
            default:
                break;  // no control source
        }
    }
}

void Sources::set_lookup(const std::uint8_t table, const SignalState state, const LookupLimits& limits) noexcept {
    lookup_states_[table - 1U] = state;
    lookup_limits_[table - 1U] = limits;
}

void Sources::set_logic(const std::uint8_t block, const SignalState state) noexcept {
    logic_states_[block - 1U] = state;
}

static_assert(implements<req::AOR_T05> && implements<req::AOR_E_QUANTITY>);
Sources::Place Sources::place(const SourceRef& ref) const noexcept {
    const bool of_output = (ref.quantity == Quantity::output_command) || (ref.quantity == Quantity::commanded_value) ||
                           (ref.quantity == Quantity::feedback_value);
    const bool digital = of_output && is_digital(objects_, ref.channel);
    namespace table = own::value_limits;
    const table::Row* const row = limits_of(digital ? Quantity::digital_command : ref.quantity);
    static_assert(implements<req::AOR_SRC_002>);
    const bool commanded_digitally = digital && (ref.quantity == Quantity::output_command);
    const SourceRef read{commanded_digitally ? Quantity::digital_command : ref.quantity, ref.channel};
    return Place{read, row, digits(cell_or(row, &table::Row::digits, Digits::whole), ref.channel)};
}

static_assert(implements<req::AOR_SRC_007> && implements<req::AOR_SRC_009> && implements<req::AOR_SRC_016>);
BlockSignal Sources::signal(const SourceRef& ref) const noexcept {
    if (ref.quantity == Quantity::none) {
        return BlockSignal{};
    }
    namespace table = own::value_limits;
    const Place read = place(ref);
    const double first = lower(cell_or(read.row, &table::Row::lower, Lower::nothing), ref.channel, read.digits);
    const double second = upper(cell_or(read.row, &table::Row::upper, Upper::nothing), ref.channel, read.digits);
    const bool ascend = first < second;
    return BlockSignal{value(read.ref, read.digits), ascend ? first : second, ascend ? second : first, state(read.ref)};
}

static_assert(implements<req::AOR_OUT_028> && implements<req::AOR_RELAY_018> && implements<req::AOR_RELAY_028>);
bool Sources::lacks(const SourceChoice& choice, const BlockSignal& signal) const noexcept {
    const SourceRef& ref = choice.ref();
    const bool is_off =
        (ref.quantity == Quantity::math) && (!objects_.get(field::o4000_math_function_enable[ref.channel]));
    return choice.is_chosen() && ((!signal.is_available()) || is_off);
}

static_assert(implements<req::AOR_SRC_009>);
BlockSignal Sources::reading(const SourceRef& ref) const noexcept {
    if (ref.quantity == Quantity::none) {
        return BlockSignal{};
    }
    const Place read = place(ref);
    return BlockSignal{value(read.ref, read.digits), 0.0, 0.0, state(read.ref)};
}

double Sources::minimum(const SourceRef& ref) const noexcept {
    namespace table = own::value_limits;
    const Place read = place(ref);
    return lesser(lower(cell_or(read.row, &table::Row::lower, Lower::nothing), ref.channel, read.digits),
                  upper(cell_or(read.row, &table::Row::upper, Upper::nothing), ref.channel, read.digits));
}

std::uint8_t Sources::digits(const Digits digits, const std::uint8_t channel) const noexcept {
    switch (digits) {
        case Digits::o6302:
            return objects_.get(field::o6302_ao_decimal_digits_pv[channel]);
        case Digits::o2502:
            return objects_.get(field::o2502_ec_decimal_digits_pv[channel]);
        case Digits::o3yz4:
            return objects_.get(lookup_fields[channel - 1U].y_digits);
        case Digits::o4032:
            static_assert(implements<req::AOR_MATH_025>);
            return objects_.get(field::o4032_math_output_decimal_digits_pv[channel]);
        case Digits::o6332:
            return objects_.get(field::o6332_ao_decimal_digits_fv[channel]);
        case Digits::tenths:
            return 1U;
        case Digits::whole:
        default:
            return 0U;
    }
}

double Sources::lower(const Lower limit, const std::uint8_t channel, const std::uint8_t digits) const noexcept {
    switch (limit) {
        case Lower::o7320:
            return command_limits_[channel - 1U].lower.of(objects_.get(field::o7320_ao_output_scaling_1_pv[channel]),
                                                          digits);
        case Lower::o2520:
            return received_limits_[channel - 1U].lower.of(objects_.get(field::o2520_ec_scaling_1_pv[channel]), digits);
        case Lower::least_y:
            return lookup_limits_[channel - 1U].least;
        case Lower::o4021:
            return calculation_limits_[channel - 1U].lower.of(
                objects_.get(field::o4021_math_output_scaling_1_pv[channel]), digits);
        case Lower::o7321:
            return field_value_limits_[channel - 1U].lower.of(
                objects_.get(field::o7321_ao_output_scaling_1_fv[channel]), digits);
        case Lower::o5022:
            return static_cast<double>(objects_.get(field::o5022_under_voltage_threshold));
        case Lower::o5032_less_o5033:
            return static_cast<double>(objects_.get(field::o5032_over_temperature_threshold)) -
                   static_cast<double>(objects_.get(field::o5033_hysteresis_to_clear_temperature_fault));
        case Lower::percent_low:
            return static_cast<double>(own::percent_low);
        case Lower::low:
        case Lower::nothing:
        default:
            return 0.0;
    }
}

double Sources::upper(const Upper limit, const std::uint8_t channel, const std::uint8_t digits) const noexcept {
    switch (limit) {
        case Upper::o7322:
            return command_limits_[channel - 1U].upper.of(objects_.get(field::o7322_ao_output_scaling_2_pv[channel]),
                                                          digits);
        case Upper::o2522:
            return received_limits_[channel - 1U].upper.of(objects_.get(field::o2522_ec_scaling_2_pv[channel]), digits);
        case Upper::greatest_y:
            return lookup_limits_[channel - 1U].greatest;
        case Upper::o4023:
            return calculation_limits_[channel - 1U].upper.of(
                objects_.get(field::o4023_math_output_scaling_2_pv[channel]), digits);
        case Upper::o7323:
            return field_value_limits_[channel - 1U].upper.of(
                objects_.get(field::o7323_ao_output_scaling_2_fv[channel]), digits);
        case Upper::o5023:
            return static_cast<double>(objects_.get(field::o5023_over_voltage_threshold));
        case Upper::o5032:
            return static_cast<double>(objects_.get(field::o5032_over_temperature_threshold));
        case Upper::percent_high:
            return static_cast<double>(own::percent_high);
        case Upper::high:
        case Upper::nothing:
        default:
            return 1.0;
    }
}

static_assert(implements<req::AOR_SRC_003> && implements<req::AOR_SRC_008> && implements<req::AOR_SRC_010>);
double Sources::value(const SourceRef& ref, const std::uint8_t digits) const noexcept {
    switch (ref.quantity) {
        case Quantity::output_command:
            return commands_[ref.channel - 1U].of(objects_.get(field::o7300_ao_output_process_value[ref.channel]),
                                                  digits);
        case Quantity::digital_command:
        case Quantity::relay_command:
            return (objects_.get(field::o6220_do_write_state_1_output_line[ref.channel]) != 0U) ? 1.0 : 0.0;
        case Quantity::extra_received:
            return received_[ref.channel - 1U].of(
                objects_.get(field::o2500_ec_extra_received_process_value[ref.channel]), digits);
        case Quantity::lookup_table:
            return tables_[ref.channel - 1U].of(objects_.get(lookup_fields[ref.channel - 1U].output), digits);
        case Quantity::math:
            return calculations_[ref.channel - 1U].of(objects_.get(field::o4030_math_output_process_value[ref.channel]),
                                                      digits);
        case Quantity::logic:
            return selections_[ref.channel - 1U].of(objects_.get(field::o3320_logic_block_output_pv[ref.channel]),
                                                    digits);
        case Quantity::commanded_value:
            return field_values_[ref.channel - 1U].of(objects_.get(field::o7330_ao_output_field_value[ref.channel]),
                                                      digits);
        case Quantity::feedback_value:
            return feedbacks_[ref.channel - 1U].of(objects_.get(field::o2370_ao_feedback_field_value[ref.channel]),
                                                   digits);
        case Quantity::supply:
            return supply_.of(objects_.get(field::o5020_power_supply_field_value));
        case Quantity::temperature:
            return temperature_.of(objects_.get(field::o5030_processor_temperature_field_value));
        case Quantity::none:
        default:
            return 0.0;
    }
}

/// Returns the state of a source. The values of the device itself are always valid, also a supply voltage or a
/// temperature outside its limits.
static_assert(implements<req::AOR_SRC_014>);
SignalState Sources::state(const SourceRef& ref) const noexcept {
    switch (ref.quantity) {
        case Quantity::output_command:
            return network_state(overdue_.commands, ref.channel);
        case Quantity::digital_command:
        case Quantity::relay_command:
            return network_state(overdue_.states, ref.channel);
        case Quantity::extra_received:
            return network_state(overdue_.extra, ref.channel);
        case Quantity::lookup_table:
            return lookup_states_[ref.channel - 1U];
        case Quantity::logic:
            return logic_states_[ref.channel - 1U];
        case Quantity::math:
        case Quantity::commanded_value:
        case Quantity::feedback_value:
            return SignalState::valid;
        case Quantity::supply:
            return measured_state(objects_.get(field::o5020_power_supply_field_value));
        case Quantity::temperature:
            return measured_state(objects_.get(field::o5030_processor_temperature_field_value));
        case Quantity::none:
        default:
            return SignalState::not_available;
    }
}

static_assert(implements<req::AOR_SRC_004> && implements<req::AOR_SRC_005> && implements<req::AOR_SRC_006>);
SignalState Sources::network_state(const std::uint32_t overdue, const std::uint8_t channel) const noexcept {
    const bool failed = silent_ || (((overdue >> std::uint32_t{channel}) & 1U) != 0U);
    return failed ? SignalState::error : SignalState::valid;
}

}  // namespace canproof::ax130751
