// SPDX-License-Identifier: Apache-2.0
// Checks the auto-null command before it is written, and applies the effects of new values of parameters.

#include "devices/ax060805/firmware/ax060805.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax060805/index.hpp"
#include "generated/ax060805/requirements.hpp"
#include "generated/ax060805/written.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;
namespace field = generated::ax060805::field;
namespace index = generated::ax060805::index;

// Distance between the indices of the same parameter of two consecutive functions: 3000h (Binary Function Output Field
// Value), 3010h, …
constexpr std::uint32_t function_index_step = generated::ax060805::index::binary_function_2_signal_source -
                                              generated::ax060805::index::binary_function_1_signal_source;

}  // namespace

static_assert(implements<req::INC_INSTALL_005>);
AbortCode Device::before_write(const EntryRef& entry, const ByteView value) {
    const bool commands_null = (entry.index == index::auto_null_command) && (value[0U] != 0U);
    if (commands_null && !inclination_.nulling_angles(settings_).has_value()) {
        return AbortCode::device_state;
    }
    return AbortCode::none;
}

static_assert(implements<req::INC_AUTO_001>);
void Device::after_write(const EntryRef& entry, const Instant now) {
    using own::Parameter;
    const own::Written change = own::written(entry.index, entry.row->subindex);
    switch (change.parameter) {
        case Parameter::can_slew_rate:
            drive_slew_rate();
            break;
        case Parameter::rpdo_received_message_process_value:
            received_[change.subindex - 1U] = true;  // the binary functions use the received value with the next sample
            break;
        case Parameter::auto_null_command:
            obey_auto_null(now);
            publish();
            break;
        case Parameter::angular_filter_type:
        case Parameter::angular_filter_constant:
            restart_filter(change.subindex - 1U);
            publish();
            break;
        case Parameter::angular_filter_rate:
            restart_filters(now);
            publish();
            break;
        case Parameter::pitch_and_roll_angle_type:
        case Parameter::initial_pitch_angle:
        case Parameter::initial_roll_angle:
            take_settings();
            restart_filters(now);
            publish();
            break;
        case Parameter::sensor_input_filter_enabled:
        case Parameter::input_filter_cut_off_frequency:
            take_input_filter();
            publish();  // the filter has a new delay, which is one of the published values
            break;
        case Parameter::binary_function_operation:
        case Parameter::binary_function_output_scaling:
        case Parameter::binary_function_output_offset:
            take_function(change.subindex - 1U);
            break;
        case Parameter::binary_function_signal_source:
        case Parameter::binary_function_signal_is_default:
        case Parameter::binary_function_signal_default_value:
        case Parameter::binary_function_signal_unary_function:
        case Parameter::binary_function_signal_scaling:
        case Parameter::binary_function_signal_offset:
            take_function(change.member - 1U);
            break;
        case Parameter::accelerometer_data_decimal_digits:
        case Parameter::accelerometer_data_inversion:
        case Parameter::accelerometer_data_offset:
        case Parameter::angular_data_decimal_digits:
        case Parameter::angular_data_inversion:
        case Parameter::angular_data_offset:
        case Parameter::rpdo_decimal_digits:
        case Parameter::rpdo_offset:
        case Parameter::continuous_signal:
        case Parameter::discrete_signal:
        case Parameter::enable_automatic_updates:
        case Parameter::start_in_operational_mode:
            publish();
            break;
        default:
            break;  // no other parameter exists: -Wswitch-enum demands a label for each parameter
    }
}

static_assert(implements<req::INC_BIN_010> && implements<req::INC_BIN_011>);
void Device::take_function(const std::size_t function) noexcept {
    const auto real = [this](const std::size_t index, const std::uint8_t sub) noexcept {
        return bit_cast<float>(objects_.read(static_cast<std::uint16_t>(index), sub));
    };
    const auto small = [this](const std::size_t index, const std::uint8_t sub) noexcept {
        return static_cast<std::uint8_t>(objects_.read(static_cast<std::uint16_t>(index), sub));
    };
    const std::size_t first = index::binary_function_1_signal_source + (function * function_index_step);
    FunctionBlock& block = functions_[function];
    for (std::uint8_t input = 1U; input <= block.inputs.size(); ++input) {
        FunctionInput& taken = block.inputs[input - 1U];
        static_assert(implements<req::INC_BIN_013>);
        sources_[function][input - 1U] = small(first, input);
        taken.has_default = small(first + 1U, input) != 0U;
        taken.default_value = real(first + 2U, input);
        taken.unary = small(first + 3U, input);
        taken.linear = Linear{real(first + 4U, input), real(first + 5U, input)};
    }
    const std::uint8_t sub = static_cast<std::uint8_t>(function + 1U);
    static_assert(implements<req::INC_BIN_012>);
    block.operation = small(index::binary_function_operation, sub);
    block.output =
        Linear{real(index::binary_function_output_scaling, sub), real(index::binary_function_output_offset, sub)};
}

static_assert(implements<req::INC_INSTALL_003> && implements<req::INC_INSTALL_006>);
void Device::obey_auto_null(const Instant now) noexcept {
    const auto angles = inclination_.nulling_angles(settings_);
    const bool commanded = objects_.get(field::o2300_auto_null_command) != 0U;
    static_assert(implements<req::INC_INSTALL_009>);
    objects_.set(field::o2300_auto_null_command, std::uint8_t{0U});
    static_assert(implements<req::INC_INSTALL_010>);
    if (commanded && angles.has_value()) {
        objects_.set(field::o2200_initial_pitch_angle, angles->pitch);
        objects_.set(field::o2210_initial_roll_angle, angles->roll);
        take_settings();
        restart_filters(now);
    }
}

static_assert(implements<req::INC_SLEW_001>);
void Device::drive_slew_rate() noexcept {
    outputs_.slew_rate_fast = objects_.get(field::o2000_can_slew_rate) != 0U;
}

}  // namespace canproof::ax060805
