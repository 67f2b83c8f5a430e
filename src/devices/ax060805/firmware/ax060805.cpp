// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/ax060805.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/profile.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;
namespace field = generated::ax060805::field;

constexpr std::uint32_t sensor_error_class = 2U;  // sub-index of 1029h (error behaviour) for sensor errors

/// Returns the value of 2000h CAN slew rate that suits a bit rate in bit/s: 1 (fast) from fast_slew_bit_rate on,
/// otherwise 0.
static_assert(implements<req::INC_SLEW_002> && implements<req::INC_K_FAST_SLEW>);
constexpr std::uint8_t suited_slew_rate(const std::uint32_t bit_rate) noexcept {
    return (bit_rate >= own::fast_slew_bit_rate) ? 1U : 0U;
}

/// Returns the number that identifies a bit rate in stored parameters: its index in the manual's Table 21 plus 1, or 0
/// for a rate outside the table.
constexpr std::uint8_t tag_of(const std::uint32_t bit_rate) noexcept {
    std::uint8_t tag{0U};
    for (const own::bit_rates::Row& row : own::bit_rates::rows) {
        if (row.bit_rate == bit_rate) {
            tag = static_cast<std::uint8_t>(row.index + 1U);
        }
    }
    return tag;
}

}  // namespace

Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept
    : Application{},
      objects_{own::tables, MutableBytes{image_}, own::profile.limit_abort},
      lss_store_{memory},
      node_{objects_, memory, queue, *this, own::error_table, own::profile, pdos_.memory()},
      factory_{factory} {}

static_assert(implements<req::INC_LSS_001> && implements<req::INC_LSS_007> && implements<req::INC_LSS_006>);
void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    static_assert(implements<req::INC_K_NODE_ID> && implements<req::INC_K_BIT_RATE>);
    const LssConfiguration stored = lss_store_.load(LssConfiguration{own::shipped_node_id, own::shipped_bit_rate});
    use_bit_rate(stored.bit_rate);
    node_.power_on(stored, inputs.can_state, inputs.can_overrun, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    advance(now);
    node_.receive(frame, now);
    forget_overdue();
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    measure_due(now);
    inputs_ = inputs;
    node_.set_controller(inputs.can_state, inputs.can_overrun, now);
}

void Device::advance(const Instant now) noexcept {
    measure_due(now);
    node_.advance(now);
    forget_overdue();
}

Instant Device::next_deadline() const noexcept {
    return earliest(node_.next_deadline(), earliest(next_sample_, next_filter_));
}

static_assert(implements<req::INC_ID_001> && implements<req::INC_ID_002>);
void Device::put_factory_values(const ParameterGroup group) {
    if (group == ParameterGroup::communication) {
        objects_.set_given(field::o1018_3_revision_number, factory_.revision);
        objects_.set_given(field::o1018_4_serial_number, factory_.serial_number);
        objects_.set_given(field::o1020_verify_configuration[1U], factory_.made_on);
        objects_.set_given(field::o1020_verify_configuration[2U], factory_.made_at);
    } else if (group == ParameterGroup::manufacturer) {
        objects_.set(field::o2000_can_slew_rate, suited_slew_rate(bit_rate_));
        objects_.set(field::o2400_calibrated_pitch_angle_data, factory_.calibration.pitch);
        objects_.set(field::o2401_calibrated_roll_angle_data, factory_.calibration.roll);
    } else {
        // no factory values: the device has no application parameters
    }
}

void Device::restart(const Instant now) {
    namespace table = own::angle_configuration;
    static_assert(implements<req::INC_T8> && implements<req::INC_RANGE_002>);
    const auto* const range = table::find(factory_.range);
    span_ = AngleSpan{cell_or(range, &table::Row::lower, span_.lower), cell_or(range, &table::Row::upper, span_.upper)};
    received_.fill(false);
    results_.fill(undefined_signal());
    take_input_filter();
    take_settings();
    for (std::size_t function = 0U; function < function_count; ++function) {
        take_function(function);
    }
    static_assert(implements<req::INC_SLEW_002> && implements<req::INC_SLEW_003>);
    if (std::uint32_t{node_.saved_tag()} != tag_of(bit_rate_)) {
        objects_.set(field::o2000_can_slew_rate,
                     suited_slew_rate(bit_rate_));  // no slew rate was stored at this bit rate
    }
    drive_slew_rate();
    starts_itself_ = objects_.get(field::o5555_start_in_operational_mode);
    restart_sensor(now);
}

/// Takes the value of 5555h start in operational mode as the stored one when a write to 1010h (store parameters) saves
/// the manufacturer parameters.
AbortCode Device::save(const ParameterGroups saved) {
    if (has_group(saved, ParameterGroup::manufacturer)) {
        static_assert(implements<req::INC_START_001> && implements<req::INC_START_003>);
        starts_itself_ = objects_.get(field::o5555_start_in_operational_mode);
    }
    return AbortCode::none;
}

static_assert(implements<req::INC_START_001> && implements<req::INC_START_002> && implements<req::INC_START_003>);
void Device::booted(const Instant now) {
    if (starts_itself_) {
        node_.start_at(now);
    }
    tell_errors(now);
    obey_lasting_errors(now);
}

/// Applies 1029h error behaviour to a sensor error that lasts beyond a reset of the communication, in the same way as
/// when it began. 1029h has priority over the self-start.
static_assert(implements<req::INC_ERR_022>);
void Device::obey_lasting_errors(const Instant now) noexcept {
    if (node_.has_error(own::error::sensor_temperature) || node_.has_error(own::error::accelerometer)) {
        node_.apply_error_behaviour(sensor_error_class, now);
    }
}

void Device::set_bit_rate(const std::uint32_t bit_rate, const Instant) {
    use_bit_rate(bit_rate);
    objects_.set(field::o2000_can_slew_rate, suited_slew_rate(bit_rate));
    drive_slew_rate();
}

void Device::use_bit_rate(const std::uint32_t bit_rate) noexcept {
    bit_rate_ = bit_rate;
    node_.tag_saves(tag_of(bit_rate));
}

LssError Device::store_configuration(const LssConfiguration& configuration) {
    return lss_store_.store(configuration);
}

static_assert(implements<req::INC_ERR_005> && implements<req::INC_ERR_006> && implements<req::INC_ERR_011>);
void Device::tell_errors(const Instant now) noexcept {
    tell_sensor_error(own::error::sensor_temperature, is_temperature_outside(), now);
    tell_sensor_error(own::error::accelerometer, !inclination_.is_measuring(), now);
}

void Device::tell_sensor_error(const ErrorId error, const bool present, const Instant now) noexcept {
    const bool begins = present && !node_.has_error(error);
    node_.set_error(error, present, now);
    if (begins) {
        node_.apply_error_behaviour(sensor_error_class, now);
    }
}

}  // namespace canproof::ax060805
