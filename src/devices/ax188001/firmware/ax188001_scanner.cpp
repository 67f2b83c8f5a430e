// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/firmware/ax188001_scanner.hpp"

#include <cmath>

#include "devices/ax188001/firmware/limit_condition.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/index.hpp"
#include "generated/ax188001/objects.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"

namespace canproof::ax188001 {

namespace {

namespace own = generated::ax188001;
namespace field = generated::ax188001::field;
namespace index = generated::ax188001::index;

const ReservedValues reserved{own::process_value_disabled, own::process_value_open};

std::uint32_t bits_of(const float value) noexcept {
    return bit_cast<std::uint32_t>(value);
}

}  // namespace

bool Scanner::is_enabled(const std::size_t channel) const noexcept {
    return objects_.get(field::o6112_tc_operating_mode[subindex(channel)]) != 0U;
}

static_assert(implements<req::TCS_IN_011>);
void Scanner::evaluate(const Instant now) noexcept {
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        measurements_[channel] = evaluate_channel(channel, now);
    }
    evaluate_average();
    evaluate_cold_junction();
    evaluate_unit(now);
    put_status();
    schedule();
}

static_assert(implements<req::TCS_IN_008> && implements<req::TCS_VAL_008>);
void Scanner::reevaluate(const own::Parameter written, const std::size_t channel, const Instant now) noexcept {
    using own::Parameter;
    switch (written) {
        case Parameter::adc_filter_frequency:
            change_filter();
            break;
        case Parameter::cj_auto_correct:
        case Parameter::tc_low_temperature_warning_threshold:
        case Parameter::tc_high_temperature_warning_threshold:
        case Parameter::tc_high_temperature_shutdown_threshold:
        case Parameter::tc_error_react_delay:
        case Parameter::tc_sensor_type:
        case Parameter::tc_operating_mode:
        case Parameter::tc_scaling_factor:
        case Parameter::tc_scaling_offset:
            measurements_[channel] = evaluate_channel(channel, now);
            evaluate_average();
            put_status();
            break;
        case Parameter::avg_operating_mode:
        case Parameter::avg_scaling_factor:
        case Parameter::avg_scaling_offset:
            evaluate_average();
            break;
        case Parameter::cj_scaling_factor:
        case Parameter::cj_scaling_offset:
            evaluate_cold_junction();
            break;
        case Parameter::fd_set_threshold:
        case Parameter::fd_clear_threshold:
        case Parameter::fd_enable_fault_detection:
        case Parameter::fd_error_response_delay:
            evaluate_unit(now);
            break;
        default:
            break;  // no other parameter exists: -Wswitch-enum demands a label for each parameter
    }
    schedule();
}

static_assert(implements<req::TCS_IN_012> && implements<req::TCS_IN_018>);
Measurement Scanner::evaluate_channel(const std::size_t channel, const Instant now) noexcept {
    const std::uint8_t sub = subindex(channel);
    const bool open = is_open(channel);
    const double microvolts = converted_uv(channel);
    static_assert(implements<req::TCS_IN_013> && implements<req::TCS_IN_019>);
    if (!open) {
        objects_.set(field::o2010_tc_input_microvolts[sub], static_cast<std::int32_t>(std::round(microvolts)));
    }
    static_assert(implements<req::TCS_VAL_005>);
    if (!is_enabled(channel)) {
        static_assert(implements<req::TCS_LIM_006> && implements<req::TCS_LIM_020>);
        for (DelayedFault& fault : faults_[channel]) {
            fault.clear();
        }
        put_channel(channel, own::field_value_invalid_bits, own::process_value_disabled);
        return Measurement{};
    }
    static_assert(implements<req::TCS_LIM_013>);
    fault_of(channel, ChannelFault::open).judge(FaultCondition{open, !open}, channel_delay(channel), now);
    static_assert(implements<req::TCS_VAL_006> && implements<req::TCS_LIM_007> && implements<req::TCS_LIM_018>);
    if (open) {
        // Without a temperature the limits cannot be evaluated. Reported limit faults stay; those that still wait for
        // the end of their delay are dropped.
        fault_of(channel, ChannelFault::high).drop();
        fault_of(channel, ChannelFault::low).drop();
        fault_of(channel, ChannelFault::shutdown).drop();
        put_channel(channel, own::field_value_invalid_bits, own::process_value_open);
        return Measurement{};
    }
    const Conversion conversion = convert(channel, microvolts);
    const double celsius = static_cast<double>(conversion.celsius);
    judge_temperature(channel, conversion, now);
    const Scaling scaling{static_cast<double>(objects_.get(field::o6126_tc_scaling_factor[sub])),
                          static_cast<double>(objects_.get(field::o6127_tc_scaling_offset[sub]))};
    static_assert(implements<req::TCS_VAL_001> && implements<req::TCS_VAL_002>);
    put_channel(channel, bits_of(conversion.celsius), measured_process_value(celsius, scaling, reserved));
    return Measurement{celsius, true};
}

void Scanner::put_channel(const std::size_t channel, const std::uint32_t field_value_bits,
                          const std::int16_t process_value) noexcept {
    objects_.write(index::tc_input_field_value, subindex(channel), field_value_bits);
    objects_.set(field::o7130_tc_input_process_value[subindex(channel)], process_value);
}

static_assert(implements<req::TCS_LIM_002> && implements<req::TCS_LIM_009> && implements<req::TCS_LIM_019>);
void Scanner::judge_temperature(const std::size_t channel, const Conversion& conversion, const Instant now) noexcept {
    // Computes in the unit of the thresholds, because the product of two numbers with few significant bits is exact. A
    // quotient is not exact, and a division is slow.
    static_assert(implements<req::TCS_K_LIMIT_RESOLUTION>);
    const double steps = static_cast<double>(own::limit_steps_per_c);
    static_assert(implements<req::TCS_K_HYSTERESIS>);
    const double hysteresis = static_cast<double>(own::limit_hysteresis_c) * steps;
    const double temperature = static_cast<double>(conversion.celsius) * steps;
    const std::uint8_t sub = subindex(channel);
    const Duration delay = channel_delay(channel);
    const double low = static_cast<double>(objects_.get(field::o4000_tc_low_temperature_warning_threshold[sub]));
    const double high = static_cast<double>(objects_.get(field::o4010_tc_high_temperature_warning_threshold[sub]));
    const double shutdown = static_cast<double>(objects_.get(field::o4020_tc_high_temperature_shutdown_threshold[sub]));

    static_assert(implements<req::TCS_LIM_001>);
    FaultCondition too_low = low_limit(temperature, low, low + hysteresis);
    too_low.begins = too_low.begins || conversion.below;
    too_low.ends = too_low.ends && !conversion.below;
    static_assert(implements<req::TCS_LIM_017>);
    FaultCondition too_hot = high_limit(temperature, shutdown, shutdown - hysteresis);
    too_hot.begins = too_hot.begins || conversion.above;
    too_hot.ends = too_hot.ends && !conversion.above;

    static_assert(implements<req::TCS_LIM_012>);
    fault_of(channel, ChannelFault::low).judge(too_low, delay, now);
    static_assert(implements<req::TCS_LIM_016>);
    fault_of(channel, ChannelFault::high).judge(high_limit(temperature, high, high - hysteresis), delay, now);
    fault_of(channel, ChannelFault::shutdown).judge(too_hot, delay, now);
}

static_assert(implements<req::TCS_AVG_003>);
void Scanner::evaluate_average() noexcept {
    using own::average_mode::Mode;
    static_assert(implements<req::TCS_T2>);
    const std::uint8_t mode = objects_.get(field::o2112_avg_operating_mode);
    const bool enabled =
        cell_or(own::average_mode::find(mode), &own::average_mode::Row::mode, Mode::disabled) == Mode::normal;
    const Measurement mean = enabled ? average(measurements_) : Measurement{};
    static_assert(implements<req::TCS_AVG_001> && implements<req::TCS_AVG_005> && implements<req::TCS_AVG_002>);
    if (mean.valid) {
        const float field_value = static_cast<float>(mean.value);
        const Scaling scaling{static_cast<double>(objects_.get(field::o2126_avg_scaling_factor)),
                              static_cast<double>(objects_.get(field::o2127_avg_scaling_offset))};
        objects_.write(index::avg_input_field_value_tc1_and_tc2, 0U, bits_of(field_value));
        objects_.set(field::o2130_avg_input_process_value,
                     measured_process_value(static_cast<double>(field_value), scaling, reserved));
        return;
    }
    static_assert(implements<req::TCS_AVG_004> && implements<req::TCS_AVG_006> && implements<req::TCS_AVG_007>);
    bool broken{false};
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        broken = broken || (is_enabled(channel) && is_open(channel));
    }
    objects_.write(index::avg_input_field_value_tc1_and_tc2, 0U, own::field_value_invalid_bits);
    objects_.set(field::o2130_avg_input_process_value, (enabled && broken) ? reserved.open : reserved.disabled);
}

static_assert(implements<req::TCS_CJ_001> && implements<req::TCS_CJ_002> && implements<req::TCS_CJ_004>);
void Scanner::evaluate_cold_junction() noexcept {
    const float field_value = static_cast<float>(cold_junction_c_);
    const Scaling scaling{static_cast<double>(objects_.get(field::o3126_cj_scaling_factor)),
                          static_cast<double>(objects_.get(field::o3127_cj_scaling_offset))};
    objects_.set(field::o3100_cj_input_field_value, field_value);
    objects_.set(field::o3130_cj_input_process_value, process_value(static_cast<double>(field_value), scaling));
}

static_assert(implements<req::TCS_FD_001>);
void Scanner::evaluate_unit(const Instant now) noexcept {
    static_assert(implements<req::TCS_K_FD_RESOLUTION>);
    const double steps = static_cast<double>(own::fault_steps_per_unit);
    const double temperature = std::round(cpu_temperature_c_ * steps);
    const double voltage = std::round(supply_v_ * steps);
    static_assert(implements<req::TCS_FD_015>);
    objects_.set(field::o5040_fd_field_value[1U], static_cast<float>(temperature));
    objects_.set(field::o5040_fd_field_value[2U], static_cast<float>(voltage));

    std::array<double, unit_fault_count> set{};
    std::array<double, unit_fault_count> clear{};
    for (std::size_t i = 0U; i < unit_fault_count; ++i) {
        set[i] = static_cast<double>(objects_.get(field::o5041_fd_set_threshold[subindex(i)]));
        clear[i] = static_cast<double>(objects_.get(field::o5042_fd_clear_threshold[subindex(i)]));
    }
    static_assert(implements<req::TCS_FD_005> && implements<req::TCS_FD_013>);
    const bool temperature_enabled = objects_.get(field::o5050_fd_enable_fault_detection[1U]) != 0U;
    const bool supply_enabled = objects_.get(field::o5050_fd_enable_fault_detection[2U]) != 0U;
    static_assert(implements<req::TCS_FD_002> && implements<req::TCS_FD_003>);
    judge_unit(UnitFault::cpu_temperature, temperature_enabled, high_limit(temperature, set[0], clear[0]), now);
    static_assert(implements<req::TCS_FD_008>);
    static_assert(implements<req::TCS_FD_010>);
    judge_unit(UnitFault::over_voltage, supply_enabled, high_limit(voltage, set[1], clear[1]), now);
    static_assert(implements<req::TCS_FD_009>);
    static_assert(implements<req::TCS_FD_011>);
    static_assert(implements<req::TCS_FD_007>);
    judge_unit(UnitFault::under_voltage, supply_enabled, low_limit(voltage, set[2], clear[2]), now);
}

static_assert(implements<req::TCS_FD_014>);
void Scanner::judge_unit(const UnitFault fault, const bool enabled, const FaultCondition& condition,
                         const Instant now) noexcept {
    const std::size_t at = static_cast<std::size_t>(fault);
    if (enabled) {
        static_assert(implements<req::TCS_FD_012> && implements<req::TCS_FD_016>);
        unit_faults_[at].judge(condition, unit_delay(at), now);
    } else {
        unit_faults_[at].clear();
    }
}

static_assert(implements<req::TCS_T7> && implements<req::TCS_LIM_005>);
void Scanner::put_status() noexcept {
    namespace table = own::channel_status;
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        const auto* const row = table::find(told(channel, ChannelFault::open), told(channel, ChannelFault::shutdown),
                                            told(channel, ChannelFault::high), told(channel, ChannelFault::low));
        objects_.set(field::o6150_tc_status[subindex(channel)], cell_or(row, &table::Row::status, std::uint8_t{0U}));
    }
}

static_assert(implements<req::TCS_LIM_003> && implements<req::TCS_LIM_015>);
Duration Scanner::channel_delay(const std::size_t channel) const noexcept {
    return milliseconds(objects_.get(field::o4030_tc_error_react_delay[subindex(channel)]));
}

/// Returns the error response delay of a fault: 5051h:1 for FD1, 5051h:2 for FD2 and FD3.
static_assert(implements<req::TCS_FD_004>);
Duration Scanner::unit_delay(const std::size_t fault) const noexcept {
    const std::uint8_t sub = (fault == static_cast<std::size_t>(UnitFault::cpu_temperature)) ? 1U : 2U;
    return milliseconds(objects_.get(field::o5051_fd_error_response_delay[sub]));
}

void Scanner::advance(const Instant now) noexcept {
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        for (DelayedFault& fault : faults_[channel]) {
            fault.advance(channel_delay(channel), now);
        }
    }
    for (std::size_t i = 0U; i < unit_fault_count; ++i) {
        unit_faults_[i].advance(unit_delay(i), now);
    }
    put_status();
    schedule();
}

/// Computes when the delay of the next waiting fault ends. It is called only after a reading, a parameter write or
/// a deadline, because nothing else changes faults and delays.
void Scanner::schedule() noexcept {
    Instant next = never;
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        const Duration delay = channel_delay(channel);
        for (const DelayedFault& fault : faults_[channel]) {
            next = earliest(next, fault.due(delay));
        }
    }
    for (std::size_t i = 0U; i < unit_fault_count; ++i) {
        next = earliest(next, unit_faults_[i].due(unit_delay(i)));
    }
    next_deadline_ = next;
}

}  // namespace canproof::ax188001
