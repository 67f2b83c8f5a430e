// What a new value of a parameter sets off.

#include "devices/ax060805/firmware/ax060805.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace field = generated::ax060805::field;

constexpr std::uint32_t slew_rate_index = 0x2000U;
constexpr std::uint32_t input_filter_index = 0x2002U;
constexpr std::uint32_t input_cut_off_index = 0x2003U;
constexpr std::uint32_t filter_type_index = 0x2050U;
constexpr std::uint32_t filter_constant_index = 0x2051U;
constexpr std::uint32_t filter_rate_index = 0x2052U;
constexpr std::uint32_t angle_type_index = 0x2100U;
constexpr std::uint32_t initial_pitch_index = 0x2200U;
constexpr std::uint32_t initial_roll_index = 0x2210U;
constexpr std::uint32_t auto_null_index = 0x2300U;
constexpr std::uint32_t received_index = 0x2500U;
constexpr std::uint32_t function_operation_index = 0x300AU;
constexpr std::uint32_t function_scaling_index = 0x300BU;
constexpr std::uint32_t function_offset_index = 0x300CU;
constexpr std::uint32_t first_function_index = 0x3010U;  // 30x0h of function 1
constexpr std::uint32_t function_index_step = 0x0010U;

/// 30x0h to 30x5h of one of the ten functions.
constexpr bool is_function_input(const std::uint16_t index) noexcept {
    constexpr std::size_t behind = first_function_index + (function_count * function_index_step);
    return (index >= first_function_index) && (index < behind);
}

}  // namespace

static_assert(implements<req::INC_INSTALL_005>);
AbortCode Device::before_write(const EntryRef& entry, const ByteView value) {
    const bool commands_null = (entry.index == auto_null_index) && (value[0U] != 0U);
    if (commands_null && !inclination_.nulling_angles(settings_).has_value()) {
        return AbortCode::device_state;
    }
    return AbortCode::none;
}

static_assert(implements<req::INC_ANGLE_009> && implements<req::INC_INSTALL_008> && implements<req::INC_AVG_007> &&
              implements<req::INC_RPDO_002> && implements<req::INC_SLEW_001> && implements<req::INC_AUTO_001>);
void Device::after_write(const EntryRef& entry, const Instant now) {
    switch (entry.index) {
        case slew_rate_index:
            drive_slew_rate();
            break;
        case received_index:
            forget_overdue();
            received_[entry.row->subindex - 1U] = true;  // the functions take it with the next sample
            break;
        case auto_null_index:
            obey_auto_null(now);
            publish();
            break;
        case filter_type_index:
        case filter_constant_index:
            restart_filter(entry.row->subindex - 1U);
            publish();
            break;
        case filter_rate_index:
            restart_filters(now);
            publish();
            break;
        case angle_type_index:
        case initial_pitch_index:
        case initial_roll_index:
            take_settings();
            restart_filters(now);
            publish();
            break;
        case input_filter_index:
        case input_cut_off_index:
            take_input_filter();
            publish();  // its delay
            break;
        case function_operation_index:
        case function_scaling_index:
        case function_offset_index:
            take_function(entry.row->subindex - 1U);
            break;
        default:
            if (is_function_input(entry.index)) {
                take_function(static_cast<std::size_t>(entry.index - first_function_index) / function_index_step);
            } else {
                publish();
            }
            break;
    }
}

static_assert(implements<req::INC_BIN_001> && implements<req::INC_BIN_010> && implements<req::INC_BIN_011>);
void Device::take_function(const std::size_t function) noexcept {
    const auto real = [this](const std::size_t index, const std::uint8_t sub) noexcept {
        return bit_cast<float>(objects_.read(static_cast<std::uint16_t>(index), sub));
    };
    const auto small = [this](const std::size_t index, const std::uint8_t sub) noexcept {
        return static_cast<std::uint8_t>(objects_.read(static_cast<std::uint16_t>(index), sub));
    };
    const std::size_t first = first_function_index + (function * function_index_step);
    FunctionBlock& block = functions_[function];
    for (std::uint8_t input = 1U; input <= block.inputs.size(); ++input) {
        FunctionInput& taken = block.inputs[input - 1U];
        sources_[function][input - 1U] = small(first, input);
        taken.has_default = small(first + 1U, input) != 0U;
        taken.default_value = real(first + 2U, input);
        taken.unary = small(first + 3U, input);
        taken.linear = Linear{real(first + 4U, input), real(first + 5U, input)};
    }
    const std::uint8_t sub = static_cast<std::uint8_t>(function + 1U);
    block.operation = small(function_operation_index, sub);
    block.output = Linear{real(function_scaling_index, sub), real(function_offset_index, sub)};
}

static_assert(implements<req::INC_INSTALL_003> && implements<req::INC_INSTALL_006>);
void Device::obey_auto_null(const Instant now) noexcept {
    const auto angles = inclination_.nulling_angles(settings_);
    const bool commanded = objects_.get(field::o2300_auto_null_command) != 0U;
    objects_.set(field::o2300_auto_null_command, std::uint8_t{0U});
    if (commanded && angles.has_value()) {
        objects_.set(field::o2200_initial_pitch_angle, angles->pitch);
        objects_.set(field::o2210_initial_roll_angle, angles->roll);
        take_settings();
        restart_filters(now);
    }
}

void Device::drive_slew_rate() noexcept {
    outputs_.slew_rate_fast = objects_.get(field::o2000_can_slew_rate) != 0U;
}

}  // namespace canproof::ax060805
