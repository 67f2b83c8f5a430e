// SPDX-License-Identifier: Apache-2.0
// The signals of the manual's Table 1 and the ten binary functions that use them.

#include <cmath>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "devices/ax060805/firmware/count_value.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;
namespace field = generated::ax060805::field;

/// Returns the distance of `signal` from `first` in the manual's Table 1; a large number when `signal` comes before
/// `first`.
constexpr std::size_t distance(const own::signal_source::Signal first,
                               const own::signal_source::Signal signal) noexcept {
    return static_cast<std::size_t>(signal) - static_cast<std::size_t>(first);
}

}  // namespace

static_assert(implements<req::INC_BIN_009> && implements<req::INC_BIN_016>);
void Device::run_functions() noexcept {
    for (std::size_t function = 0U; function < function_count; ++function) {
        FunctionBlock& block = functions_[function];
        for (std::size_t input = 0U; input < block.inputs.size(); ++input) {
            static_assert(implements<req::INC_SIG_007>);
            block.inputs[input].source = signal_of(sources_[function][input]);
        }
        static_assert(implements<req::INC_BIN_015>);
        results_[function] = evaluate(block);
        static_assert(implements<req::INC_BIN_008>);
        objects_.set(field::o3000_binary_function_output_field_value[static_cast<std::uint8_t>(function + 1U)],
                     count_value(as_continuous(results_[function]), CountScale{}));
    }
}

static_assert(implements<req::INC_RPDO_003>);
/// Forgets all received values once when an RPDO becomes overdue. After that the binary functions use a received value
/// only when it has been written again.
void Device::forget_overdue() noexcept {
    const std::uint32_t overdue = node_.overdue_rpdos();
    if ((overdue & ~overdue_) != 0U) {
        received_.fill(false);
    }
    overdue_ = overdue;
}

static_assert(implements<req::INC_SIG_001> && implements<req::INC_SIG_002> && implements<req::INC_SIG_005>);
Signal Device::signal_of(const std::uint8_t source) const noexcept {
    using Source = own::signal_source::Signal;
    static_assert(implements<req::INC_T1> && implements<req::INC_GLOBAL_003>);
    static_assert(implements<req::INC_SIG_006>);
    const Source chosen = cell_or(own::signal_source::find(source), &own::signal_source::Row::signal, Source::none);
    const std::size_t function = distance(Source::binary_function_1, chosen);
    if (function < function_count) {
        return results_[function];
    }
    const std::size_t received = distance(Source::received_1, chosen);
    if (received < received_count) {
        return received_signal(received);
    }
    switch (chosen) {
        case Source::acceleration_x:
            return acceleration_signal(1U);
        case Source::acceleration_y:
            return acceleration_signal(2U);
        case Source::acceleration_z:
            return acceleration_signal(3U);
        case Source::sensor_temperature:
            return std::isnan(sampled_.sensor_temperature) ? undefined_signal()
                                                           : continuous_signal(sampled_.sensor_temperature);
        case Source::pitch:
            return angle_signal(pitch_angle);
        case Source::roll:
            return angle_signal(roll_angle);
        case Source::gravity_angle:
            return angle_signal(gravity_tilt);
        case Source::latency:
            return continuous_signal(latency_ms());
        case Source::figure_of_merit:
            return discrete_signal(objects_.get(field::o4020_angular_figure_of_merit));
        case Source::discrete_constant:
            return discrete_signal(objects_.get(field::o4080_discrete_signal));
        case Source::continuous_constant:
            return continuous_signal(objects_.get(field::o4070_continuous_signal));
        case Source::zero:
            return continuous_signal(0.0F);
        case Source::one:
            return continuous_signal(1.0F);
        case Source::supply:
            return continuous_signal(objects_.get(field::o5020_power_supply_field_value));
        case Source::processor_temperature:
            return continuous_signal(objects_.get(field::o5030_processor_temperature_field_value));
        case Source::none:
        default:
            return undefined_signal();
    }
}

static_assert(implements<req::INC_FV_009>);
static_assert(implements<req::INC_FV_011>);
Signal Device::acceleration_signal(const std::uint8_t axis) const noexcept {
    return inclination_.is_measuring() ? continuous_signal(given_acceleration(axis)) : undefined_signal();
}

static_assert(implements<req::INC_FV_009>);
static_assert(implements<req::INC_FV_011>);
Signal Device::angle_signal(const std::size_t angle) const noexcept {
    return inclination_.is_measuring() ? continuous_signal(given_angle(angle)) : undefined_signal();
}

static_assert(implements<req::INC_RPDO_001>);
Signal Device::received_signal(const std::size_t place) const noexcept {
    static_assert(implements<req::INC_RPDO_002>);
    if (!received_[place]) {
        return undefined_signal();
    }
    const std::uint8_t sub = static_cast<std::uint8_t>(place + 1U);
    const ReceivedScale scale{objects_.get(field::o2501_rpdo_decimal_digits[sub]),
                              objects_.get(field::o2502_rpdo_offset[sub])};
    return continuous_signal(
        value_of_count(objects_.get(field::o2500_rpdo_received_message_process_value[sub]), scale));
}

}  // namespace canproof::ax060805
