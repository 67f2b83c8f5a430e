// SPDX-License-Identifier: Apache-2.0
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "firmware/canopen/indicator.hpp"
#include "generated/cbx_ao412/constants.hpp"
#include "generated/cbx_ao412/index.hpp"
#include "generated/cbx_ao412/profile.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "generated/cbx_ao412/written.hpp"

namespace canproof::cbx_ao412 {

namespace {

namespace own = generated::cbx_ao412;
namespace field = generated::cbx_ao412::field;
namespace index = generated::cbx_ao412::index;
using own::IndicatorState;

constexpr std::uint32_t autostart_enabled = 8U;  // value of 1F80h NMT startup (7.9.22)
constexpr std::uint32_t max_node_id = 0x7FU;

// The full scale is the reference voltage times the gain of the differential amplifier (4.3.1).
const VoltageOutputCircuit circuit{own::reference_voltage * (own::feedback_resistor / own::input_resistor),
                                   own::dac_steps, own::codes_per_step};

static_assert(implements<req::AO4_T5> && implements<req::AO4_LED_005> && implements<req::AO4_LED_008>);
IndicatorPattern pattern_of(const IndicatorState state) noexcept {
    namespace table = own::indicator_flashes;
    const auto* const row = table::find(state);
    const auto time = [row](std::uint16_t table::Row::*const column) noexcept {
        return milliseconds(cell_or(row, column, std::uint16_t{0U}));
    };
    return IndicatorPattern{cell_or(row, &table::Row::flashes, std::uint8_t{0U}), time(&table::Row::on_ms),
                            time(&table::Row::gap_ms), time(&table::Row::pause_ms)};
}

/// Returns the time by which the red LEDs begin their pattern later than the green LEDs: the length of one flash
/// (3.2.1, note).
static_assert(implements<req::AO4_LED_006>);
Duration red_shift() noexcept {
    return pattern_of(IndicatorState::blinking).on;
}

template <typename Row>
IndicatorState led_of(const Row* const row) noexcept {
    return cell_or(row, &Row::led, IndicatorState::off);
}

}  // namespace

Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept
    : Application{},
      objects_{own::tables, MutableBytes{image_}, own::profile.limit_abort},
      node_{objects_, memory, queue, *this, own::error_table, own::profile, pdos_.memory()},
      factory_{factory} {}

void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    outputs_ = Outputs{};
    driven_.fill(Driven{});
    internal_fault_shown_ = false;
    static_assert(implements<req::AO4_SW_001> && implements<req::AO4_SW_004>);
    node_id_ = static_cast<std::uint8_t>((inputs.switch_high * 16U) + inputs.switch_low);
    static_assert(implements<req::AO4_SW_003> && implements<req::AO4_T11>);
    bit_rate_ = cell_or(own::bit_rate_switch::find(inputs.switch_baud), &own::bit_rate_switch::Row::bit_rate,
                        std::uint32_t{0U});
    static_assert(implements<req::AO4_SW_002>);
    runs_ = (node_id_ != 0U) && (node_id_ <= max_node_id);
    if (runs_) {
        node_.power_on(LssConfiguration{node_id_}, inputs.can_state, inputs.can_overrun, now);
    }
    set_inputs(inputs, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    if (runs_) {
        node_.receive(frame, now);
    }
    drive_leds(now);
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    if (runs_) {
        node_.set_controller(inputs.can_state, inputs.can_overrun, now);
        watch_internal_faults(now);
        set_failed(communication_failed_, has_internal_fault());
    } else {
        internal_fault_shown_ = internal_fault_shown_ || has_internal_fault();
    }
    drive_leds(now);
}

/// Reports internal faults. A stored set of parameters that could not be used also counts as an internal software error
/// until the next NMT reset node (7.9.4).
static_assert(implements<req::AO4_ERR_009> && implements<req::AO4_ERR_010> && implements<req::AO4_ERR_018>);
void Device::watch_internal_faults(const Instant now) noexcept {
    static_assert(implements<req::AO4_ERR_023>);
    const bool software = inputs_.internal_fault || node_.has_error(ErrorId::stored_set_checksum);
    internal_fault_shown_ = internal_fault_shown_ || software || inputs_.hardware_fault;
    node_.set_error(ErrorId::internal_software, software, now);
    node_.set_error(own::error::hardware, inputs_.hardware_fault, now);
}

void Device::advance(const Instant now) noexcept {
    if (runs_) {
        node_.advance(now);
    }
    drive_leds(now);
}

Instant Device::next_deadline() const noexcept {
    return runs_ ? earliest(node_.next_deadline(), next_led_change_) : next_led_change_;
}

static_assert(implements<req::AO4_PROG_001>);
AbortCode Device::check_access(const EntryRef& entry) {
    // Program data can be loaded only in the boot loader, but the application is running (7.12).
    return (entry.index == index::program_data) ? AbortCode::device_state : AbortCode::none;
}

static_assert(implements<req::AO4_AOUT_005> && implements<req::AO4_AOUT_011> && implements<req::AO4_AOUT_014>);
void Device::after_write(const EntryRef& entry, const Instant) {
    using own::Parameter;
    const own::Written change = own::written(entry.index, entry.row->subindex);
    switch (change.parameter) {
        case Parameter::write_analogue_output_16_bit:
            if (!failed_) {
                command_output(change.subindex,
                               objects_.get(field::o6411_write_analogue_output_16_bit[change.subindex]));
            }
            break;
        case Parameter::calibration_offset_value:
        case Parameter::calibration_gain_value:
            drive_output(change.subindex);
            break;
        case Parameter::program_data:
        case Parameter::program_control:
        case Parameter::analogue_output_error_mode:
        case Parameter::analogue_output_error_value:
            break;  // a write to these objects changes no output immediately
        default:
            break;  // no other parameter exists: -Wswitch-enum demands a label for each parameter
    }
}

static_assert(implements<req::AO4_ID_001> && implements<req::AO4_PROG_003>);
void Device::put_factory_values(const ParameterGroup group) {
    if (group == ParameterGroup::communication) {
        put_version(index::manufacturer_hardware_version, factory_.hardware_version);
        put_version(index::manufacturer_software_version, factory_.software_version);
        objects_.set_given(field::o1f52_1_application_software_date, factory_.software_date);
        objects_.set_given(field::o1f52_2_application_software_time, factory_.software_time);
        objects_.set_given(field::o1018_3_revision_number, factory_.revision);
        objects_.set_given(field::o1018_4_serial_number, factory_.serial_number);
    }
    for (std::uint8_t number = 1U; (group == ParameterGroup::manufacturer) && (number <= output_count); ++number) {
        static_assert(implements<req::AO4_AOUT_009> && implements<req::AO4_AOUT_012>);
        objects_.set(field::o2404_calibration_offset_value[number], factory_.offset[number - 1U]);
        objects_.set(field::o2405_calibration_gain_value[number], factory_.gain[number - 1U]);
    }
}

void Device::put_version(const std::uint16_t index, const VersionText& text) noexcept {
    const auto entry = objects_.find(index, 0U);
    if (entry.ok() && (text[0] != 0U)) {
        static_cast<void>(objects_.put(entry.value(), ByteView{text}));
    }
}

static_assert(implements<req::AO4_AOUT_010> && implements<req::AO4_AOUT_013>);
void Device::restart(const Instant) {
    const bool is_off_the_bus = node_.can_state() == CanState::bus_off;
    failed_ = false;
    internal_fault_shown_ = false;
    set_failed(is_off_the_bus, has_internal_fault());
    if (!failed_) {
        command_outputs();
    }
}

static_assert(implements<req::AO4_START_001> && implements<req::AO4_START_005> && implements<req::AO4_ERR_012>);
void Device::booted(const Instant now) {
    watch_internal_faults(now);
    if (objects_.get(field::o1f80_nmt_startup) == autostart_enabled) {
        static_assert(implements<req::AO4_START_006>);
        node_.start_at(now + milliseconds(objects_.get(field::o1f91_self_starting_nodes_timing_parameters[1U])));
    }
}

void Device::communication_failed(const bool failed, const Instant) {
    set_failed(failed, has_internal_fault());
}

static_assert(implements<req::AO4_AOUT_006> && implements<req::AO4_AOUT_008>);
void Device::set_failed(const bool communication, const bool internal) noexcept {
    communication_failed_ = communication;
    const bool failed = communication || internal;
    if (failed && !failed_) {
        for (std::uint8_t number = 1U; number <= output_count; ++number) {
            apply_error_mode(number);
        }
    }
    failed_ = failed;
}

static_assert(implements<req::AO4_T_ERROR_MODE> && implements<req::AO4_AOUT_007> && implements<req::AO4_AOUT_015>);
void Device::apply_error_mode(const std::uint8_t number) noexcept {
    namespace modes = own::error_mode;
    const std::uint8_t mode = objects_.get(field::o6443_analogue_output_error_mode[number]);
    const modes::Action action = cell_or(modes::find(mode), &modes::Row::action, modes::Action::zero);
    if (action == modes::Action::zero) {
        driven_[number - 1U] = Driven{};
        drive_output(number);
    } else if (action == modes::Action::error_value) {
        const auto bits = static_cast<std::uint32_t>(objects_.get(field::o6444_analogue_output_error_value[number]));
        command_output(number, static_cast<std::int16_t>(static_cast<std::uint16_t>(bits >> 16U)));
    } else {
        drive_output(number);  // keeps the value; a reset may have loaded another calibration
    }
}

void Device::command_outputs() noexcept {
    for (std::uint8_t number = 1U; number <= output_count; ++number) {
        command_output(number, objects_.get(field::o6411_write_analogue_output_16_bit[number]));
    }
}

void Device::command_output(const std::uint8_t number, const std::int16_t value) noexcept {
    driven_[number - 1U] = Driven{true, value};
    drive_output(number);
}

/// Computes the voltage of an output and stores it in outputs_. The voltage depends only on driven_, 2404h calibration
/// offset and 2405h calibration gain. Every change of one of these, including the loading of a stored set, must call
/// this function.
static_assert(implements<req::AO4_AOUT_001> && implements<req::AO4_AOUT_004>);
void Device::drive_output(const std::uint8_t number) noexcept {
    const Driven driven = driven_[number - 1U];
    if (!driven.on) {
        outputs_.aout[number - 1U] = 0.0F;
        return;
    }
    const float gain_codes = static_cast<float>(objects_.get(field::o2405_calibration_gain_value[number]));
    const float offset_codes = static_cast<float>(objects_.get(field::o2404_calibration_offset_value[number]));
    const float offset_lsb_v = own::calibration_offset_full_scale / 32768.0F;
    const OutputCalibration calibration{1.0F + (gain_codes / static_cast<float>(own::calibration_gain_divisor)),
                                        offset_codes * offset_lsb_v};
    outputs_.aout[number - 1U] = step_voltage(output_step(driven.value, circuit, calibration), circuit);
}

static_assert(implements<req::AO4_LED_001> && implements<req::AO4_T7>);
IndicatorState Device::status_indicator() const noexcept {
    return led_of(own::status_led::find(runs_, node_.state()));
}

static_assert(implements<req::AO4_LED_002> && implements<req::AO4_T6>);
IndicatorState Device::can_error_indicator() const noexcept {
    return led_of(own::can_error_led::find(!runs_, node_.can_state(), node_.has_error(ErrorId::guard_or_heartbeat)));
}

bool Device::show(const IndicatorState state, const Duration shift, const Instant now) noexcept {
    static_assert(implements<req::AO4_LED_006> && implements<req::AO4_LED_009>);
    const IndicatorPhase phase = indicator_phase(pattern_of(state), now, shift);
    next_led_change_ = earliest(next_led_change_, phase.next_change);
    return phase.lit;
}

void Device::drive_leds(const Instant now) noexcept {
    next_led_change_ = never;
    outputs_.led_e = show(can_error_indicator(), red_shift(), now);
    outputs_.led_s = show(status_indicator(), Duration{}, now);
    static_assert(implements<req::AO4_LED_003> && implements<req::AO4_LED_007> && implements<req::AO4_T8>);
    outputs_.led_m = show(led_of(own::error_led::find(inputs_.can_overrun, internal_fault_shown_)), red_shift(), now);
    static_assert(implements<req::AO4_LED_004> && implements<req::AO4_T9>);
    outputs_.led_p = show(led_of(own::power_led::find(runs_)), Duration{}, now);
}

}  // namespace canproof::cbx_ao412
