// SPDX-License-Identifier: Apache-2.0
// Processes the samples of the sensor, and writes the resulting accelerations and angles to the object dictionary.

#include <cmath>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "devices/ax060805/firmware/count_value.hpp"
#include "devices/ax060805/firmware/low_pass.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/index.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;
namespace field = generated::ax060805::field;
namespace index = generated::ax060805::index;

const Duration sample_period = microseconds(own::sample_period_us);

/// Returns whether the value lies within the range of the sensor; NaN does not.
bool is_measurement(const float acceleration) noexcept {
    return std::fabs(acceleration) <= own::sensor_range;
}

constexpr float reversed_if(const bool reversed, const float value) noexcept {
    return reversed ? -value : value;
}

}  // namespace

/// Clears all measurements after a reset, takes the first sample and publishes it.
static_assert(implements<req::INC_FILTER_001>);
void Device::restart_sensor(const Instant now) noexcept {
    inclination_.restart();
    for (AngleFilter& filter : filters_) {
        filter.forget();
    }
    take_sample();
    restart_filters(now);
    publish();
    run_functions();
    next_sample_ = now + sample_period;
}

static_assert(implements<req::INC_FILTER_001> && implements<req::INC_AVG_004> && implements<req::INC_K_SAMPLE_PERIOD>);
void Device::measure_due(const Instant now) noexcept {
    const Duration rate = milliseconds(objects_.get(field::o2052_angular_filter_rate));
    static_assert(implements<req::INC_FILTER_009>);
    const bool samples = is_due(next_sample_, sample_period, now);
    static_assert(implements<req::INC_AVG_019>);
    const bool filters = is_due(next_filter_, rate, now);
    const bool had_failed = !inclination_.is_measuring();
    if (!samples && !filters) {
        return;
    }
    if (samples) {
        take_sample();
        next_sample_ = next_after(next_sample_, sample_period, now);
    }
    if (filters) {
        next_filter_ = next_after(next_filter_, rate, now);
    }
    static_assert(implements<req::INC_AVG_014>);
    pass_filters(samples, filters);
    if (had_failed && inclination_.is_measuring()) {
        restart_filters(now);
    }
    if (samples) {
        publish();
        run_functions();
        if (node_.state() != NmtState::initialising) {
            tell_errors(now);
        }
    } else {
        publish_angles();  // without a new sample only the filtered angles can change
    }
}

static_assert(implements<req::INC_ERR_006> && implements<req::INC_K_SENSOR_RANGE>);
bool Device::has_sensor_fault() const noexcept {
    return sampled_.accelerometer_fault || !is_measurement(sampled_.acceleration_x) ||
           !is_measurement(sampled_.acceleration_y) || !is_measurement(sampled_.acceleration_z);
}

static_assert(implements<req::INC_FV_007>);
static_assert(implements<req::INC_FV_012>);
void Device::take_sample() noexcept {
    sampled_ = inputs_;
    if (has_sensor_fault()) {
        inclination_.fail();
    } else {
        inclination_.sample(Vector3{sampled_.acceleration_x, sampled_.acceleration_y, sampled_.acceleration_z},
                            settings_);
    }
}

static_assert(implements<req::INC_AVG_005>);
void Device::pass_filters(const bool sampled, const bool timed) noexcept {
    if (!inclination_.is_measuring()) {
        return;
    }
    for (std::size_t angle = 0U; angle < angle_count; ++angle) {
        const bool unfiltered = filter_kind(static_cast<std::uint8_t>(angle + 1U)) == AngleFilterKind::none;
        if (unfiltered ? sampled : timed) {
            filters_[angle].add(inclination_.angles()[angle]);
        }
    }
}

static_assert(implements<req::INC_FILTER_002> && implements<req::INC_FILTER_004>);
static_assert(implements<req::INC_FILTER_008>);
void Device::take_input_filter() noexcept {
    const bool filtered = objects_.get(field::o2002_sensor_input_filter_enabled) != 0U;
    const float cut_off = static_cast<float>(objects_.get(field::o2003_input_filter_cut_off_frequency));
    settings_.filter_share = filtered ? low_pass_coefficient(cut_off, sample_period) : 1.0F;
}

static_assert(implements<req::INC_K_GIMBAL_LOCK> && implements<req::INC_K_LEAST_GRAVITY>);
void Device::take_settings() noexcept {
    settings_.calibration = PitchRoll{objects_.get(field::o2400_calibrated_pitch_angle_data),
                                      objects_.get(field::o2401_calibrated_roll_angle_data)};
    settings_.installation =
        PitchRoll{objects_.get(field::o2200_initial_pitch_angle), objects_.get(field::o2210_initial_roll_angle)};
    static_assert(implements<req::INC_ANGLE_009>);
    settings_.euler = objects_.get(field::o2100_pitch_and_roll_angle_type) == 0U;
    settings_.gimbal_lock_cone = own::gimbal_lock_cone;
    settings_.least_gravity = own::least_gravity;
    static_assert(implements<req::INC_ANGLE_017>);
    inclination_.update(settings_);
}

static_assert(implements<req::INC_INSTALL_008> && implements<req::INC_AVG_015>);
void Device::restart_filters(const Instant now) noexcept {
    for (std::size_t angle = 0U; angle < angle_count; ++angle) {
        restart_filter(angle);
    }
    next_filter_ = now + milliseconds(objects_.get(field::o2052_angular_filter_rate));
}

static_assert(implements<req::INC_AVG_012> && implements<req::INC_AVG_013>);
void Device::restart_filter(const std::size_t angle) noexcept {
    const std::uint8_t sub = static_cast<std::uint8_t>(angle + 1U);
    // the gravity angle and the Euler pitch cover half a turn only
    const bool is_circular = (angle != gravity_tilt) && !(settings_.euler && (angle == pitch_angle));
    filters_[angle].restart(filter_kind(sub), objects_.get(field::o2051_angular_filter_constant[sub]), is_circular);
    if (inclination_.is_measuring()) {
        filters_[angle].add(inclination_.angles()[angle]);
    }
}

static_assert(implements<req::INC_T4>);
AngleFilterKind Device::filter_kind(const std::uint8_t subindex) const noexcept {
    const std::uint8_t type = objects_.get(field::o2050_angular_filter_type[subindex]);
    return cell_or(own::angle_filter::find(type), &own::angle_filter::Row::filter, AngleFilterKind::none);
}

static_assert(implements<req::INC_K_TEMPERATURE_LOW> && implements<req::INC_K_TEMPERATURE_HIGH>);
bool Device::is_temperature_outside() const noexcept {
    const float temperature = sampled_.sensor_temperature;
    const bool inside = (temperature >= own::sensor_temperature_low) && (temperature <= own::sensor_temperature_high);
    return !inside;  // NaN counts as outside
}

// The TPDOs are not notified of changes, because their transmission type is fixed at 254 and only their event timers
// trigger them (4.2.15).
void Device::publish() noexcept {
    publish_accelerations();
    publish_angles();
    publish_diagnostics();
}

static_assert(implements<req::INC_FV_005>);
void Device::publish_accelerations() noexcept {
    for (std::uint8_t axis = 1U; axis <= angle_count; ++axis) {
        const CountScale scale{objects_.get(field::o2010_accelerometer_data_decimal_digits[axis]),
                               objects_.get(field::o2020_accelerometer_data_offset[axis])};
        objects_.set(field::o4000_accelerometer_axis_data_field_value[axis],
                     count_value(given_acceleration(axis), scale));
    }
}

void Device::publish_angles() noexcept {
    constexpr std::array<Field<std::int16_t>, angle_count> shown{{field::o4030_pitch_angle_data_field_value,
                                                                  field::o4040_roll_angle_data_field_value,
                                                                  field::o4050_gravity_angle_data_field_value}};
    for (std::uint8_t sub = 1U; sub <= angle_count; ++sub) {
        const CountScale scale{objects_.get(field::o2030_angular_data_decimal_digits[sub]),
                               objects_.get(field::o2040_angular_data_offset[sub])};
        objects_.set(shown[sub - 1U], count_value(given_angle(sub - 1U), scale));
    }
}

void Device::publish_diagnostics() noexcept {
    namespace merit = own::figure_of_merit;
    static_assert(implements<req::INC_FOM_001> && implements<req::INC_T5>);
    const auto* const row = merit::find(!inclination_.is_measuring(), is_temperature_outside(),
                                        inclination_.is_weightless(), inclination_.is_roll_unsure());
    const std::uint8_t worst = merit::rows[0U].state;
    objects_.set(field::o4020_angular_figure_of_merit, cell_or(row, &merit::Row::state, worst));
    objects_.set(field::o4010_angular_measurement_latency, whole_milliseconds(latency_ms()));
    static_assert(implements<req::INC_FV_006> && implements<req::INC_FV_010>);
    if (!std::isnan(sampled_.sensor_temperature)) {
        objects_.set(field::o4060_sensor_temperature_data, count_value(sampled_.sensor_temperature, CountScale{}));
    }
    static_assert(implements<req::INC_GLOBAL_001> && implements<req::INC_GLOBAL_002>);
    show_if_valid(index::power_supply_field_value, sampled_.supply_voltage);
    show_if_valid(index::processor_temperature_field_value, sampled_.processor_temperature);
}

/// Writes a measured value to its object. A value outside the limits of the object is not a measurement: the object
/// then keeps its last value.
void Device::show_if_valid(const std::uint16_t index, const float value) noexcept {
    const auto entry = objects_.find(index, 0U);
    std::array<std::uint8_t, sizeof(float)> bytes{};
    write_le(MutableBytes{bytes}, 0U, sizeof(float), bit_cast<std::uint32_t>(value));
    static_assert(implements<req::INC_GLOBAL_004>);
    static_assert(implements<req::INC_GLOBAL_005>);
    if (entry.ok() && (objects_.check_value(entry.value(), ByteView{bytes}) == AbortCode::none)) {
        static_cast<void>(objects_.put(entry.value(), ByteView{bytes}));
    }
}

/// Returns the acceleration of an axis in g, with its sign reversed if 2011h accelerometer data inversion is set for
/// this axis.
static_assert(implements<req::INC_ANGLE_001> && implements<req::INC_FV_004>);
float Device::given_acceleration(const std::uint8_t axis) const noexcept {
    const Vector3& sensed = inclination_.acceleration();
    const std::array<float, angle_count> axes{{sensed.x, sensed.y, sensed.z}};
    return reversed_if(objects_.get(field::o2011_accelerometer_data_inversion[axis]) != 0U, axes[axis - 1U]);
}

static_assert(implements<req::INC_RANGE_003> && implements<req::INC_FV_008>);
/// Returns an angle in degrees after its filter. Pitch and roll lie in the angle range of the unit (Table 8 of the
/// manual). The sign is reversed if 2031h angular data inversion is set for this angle.
float Device::given_angle(const std::size_t angle) const noexcept {
    const float measured = filters_[angle].output();
    static_assert(implements<req::INC_RANGE_007>);
    const float ranged = (angle == gravity_tilt) ? measured : in_span(measured, span_);
    const std::uint8_t sub = static_cast<std::uint8_t>(angle + 1U);
    static_assert(implements<req::INC_RANGE_006> && implements<req::INC_ANGLE_021>);
    return reversed_if(objects_.get(field::o2031_angular_data_inversion[sub]) != 0U, ranged);
}

static_assert(implements<req::INC_LATENCY_001>);
float Device::latency_ms() const noexcept {
    const std::uint16_t rate = objects_.get(field::o2052_angular_filter_rate);
    float slowest{0.0F};
    for (std::size_t angle = 0U; angle < angle_count; ++angle) {
        const std::uint8_t sub = static_cast<std::uint8_t>(angle + 1U);
        const std::uint16_t samples = objects_.get(field::o2051_angular_filter_constant[sub]);
        slowest = std::fmax(slowest, angle_filter_delay_ms(filter_kind(sub), samples, rate));
    }
    const bool filtered = objects_.get(field::o2002_sensor_input_filter_enabled) != 0U;
    const float cut_off = static_cast<float>(objects_.get(field::o2003_input_filter_cut_off_frequency));
    return filtered ? (slowest + low_pass_delay_ms(cut_off)) : slowest;
}

}  // namespace canproof::ax060805
