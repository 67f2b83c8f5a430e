#include "devices/ax060805/firmware/ax060805.hpp"

#include <cmath>

#include "devices/ax060805/firmware/count_value.hpp"
#include "firmware/axiomatic/axiomatic.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;
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
constexpr std::uint32_t supply_index = 0x5020U;
constexpr std::uint32_t processor_temperature_index = 0x5030U;
constexpr std::uint32_t sensor_error_class = 2U;  // sub-index of 1029h
constexpr std::uint32_t no_state_change = 1U;     // value of 1029h (4.2.13)

constexpr ErrorId temperature_error = ErrorId::first_of_device;
constexpr ErrorId accelerometer_error = error_after(ErrorId::first_of_device, 1U);
const Duration sample_period = microseconds(own::sample_period_us);

static_assert(implements<req::INC_T21> && implements<req::INC_LSS_004>);
const auto bit_rates = lss_bit_rates(own::t_inc_t21::rows);

// What the node does for every device, in the manner of this one.
static_assert(implements<req::INC_ERR_002> && implements<req::INC_ERR_003> && implements<req::INC_ERR_007> &&
              implements<req::INC_ERR_008> && implements<req::INC_ERR_009> && implements<req::INC_ERR_010> &&
              implements<req::INC_ERR_012> && implements<req::INC_HB_001> && implements<req::INC_HB_002> &&
              implements<req::INC_LSS_002> && implements<req::INC_LSS_003> && implements<req::INC_LSS_005> &&
              implements<req::INC_STORE_001> && implements<req::INC_STORE_002>);
static_assert(implements<req::INC_PDO_001> && implements<req::INC_PDO_002> && implements<req::INC_PDO_003> &&
              implements<req::INC_PDO_004> && implements<req::INC_PDO_005> && implements<req::INC_PDO_006> &&
              implements<req::INC_PDO_007> && implements<req::INC_OD_LIST> && implements<req::INC_FILTER_006>);
const NodeProfile profile = axiomatic_profile(bit_rates);

constexpr ErrorId id_of(const own::t_inc_t22::Error error) noexcept {
    using own::t_inc_t22::Error;
    switch (error) {
        case Error::sensor_temperature:
            return temperature_error;
        case Error::can_overrun:
            return ErrorId::can_overrun;
        case Error::life_guarding:
            return ErrorId::life_guarding;
        case Error::heartbeat:
            return ErrorId::heartbeat_1;
        case Error::bus_off_recovered:
            return ErrorId::bus_off_recovered;
        case Error::rpdo_length:
            return ErrorId::rpdo_length;
        case Error::rpdo_timeout:
            return ErrorId::rpdo_timeout;
        case Error::stored_set_checksum:
            return ErrorId::stored_set_checksum;
        case Error::accelerometer:
        default:
            return accelerometer_error;
    }
}

static_assert(implements<req::INC_T22> && implements<req::INC_ERR_001> && implements<req::INC_ERR_004>);
constexpr ErrorTable make_error_table() noexcept {
    ErrorTable table{};
    for (const own::t_inc_t22::Row& row : own::t_inc_t22::rows) {
        table[static_cast<std::size_t>(id_of(row.error))] =
            ErrorRow{row.code, row.register_bits, row.sent, row.listed, row.detail};
    }
    return table;
}
const ErrorTable error_table = make_error_table();

/// Within the range of the sensor; NaN is not.
bool is_measurement(const float acceleration) noexcept {
    return std::fabs(acceleration) <= own::sensor_range;
}

/// A value of 2000h.
constexpr std::uint8_t suited_slew_rate(const std::uint32_t bit_rate) noexcept {
    return (bit_rate >= own::fast_slew_bit_rate) ? 1U : 0U;
}

/// The tag of a save, which tells later at which bit rate it was made: 1 and more by Table 21, 0 for a rate that
/// is not there.
constexpr std::uint8_t tag_of(const std::uint32_t bit_rate) noexcept {
    std::uint8_t tag{0U};
    for (const own::t_inc_t21::Row& row : own::t_inc_t21::rows) {
        if (row.bit_rate == bit_rate) {
            tag = static_cast<std::uint8_t>(row.index + 1U);
        }
    }
    return tag;
}

constexpr float reversed_if(const bool reversed, const float value) noexcept {
    return reversed ? -value : value;
}

/// 30x0h to 30x5h of one of the ten functions.
constexpr bool is_function_input(const std::uint16_t index) noexcept {
    constexpr std::size_t behind = first_function_index + (function_count * function_index_step);
    return (index >= first_function_index) && (index < behind);
}

/// How far `signal` stands behind `first` in Table 1; large when it stands before.
constexpr std::size_t distance(const own::t_inc_t1::Signal first, const own::t_inc_t1::Signal signal) noexcept {
    return static_cast<std::size_t>(signal) - static_cast<std::size_t>(first);
}

}  // namespace

Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept
    : Application{},
      objects_{own::tables, MutableBytes{image_}, profile.limit_abort},
      lss_store_{memory},
      node_{objects_, memory, queue, *this, error_table, profile, pdos_.memory()},
      factory_{factory} {}

static_assert(implements<req::INC_LSS_001> && implements<req::INC_LSS_006> && implements<req::INC_K_NODE_ID> &&
              implements<req::INC_K_BIT_RATE>);
void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    const LssConfiguration stored = lss_store_.load(LssConfiguration{own::shipped_node_id, own::shipped_bit_rate});
    use_bit_rate(stored.bit_rate);
    node_.power_on(stored, now);
    set_inputs(inputs, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    measure_due(now);
    node_.receive(frame, now);
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    measure_due(now);
    inputs_ = inputs;
    node_.set_controller(inputs.can_state, inputs.can_overrun, now);
}

void Device::advance(const Instant now) noexcept {
    measure_due(now);
    node_.advance(now);
}

Instant Device::next_deadline() const noexcept {
    return earliest(node_.next_deadline(), earliest(next_sample_, next_filter_));
}

AbortCode Device::check_access(const EntryRef&) {
    return AbortCode::none;  // no entry depends on the state of the device
}

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

static_assert(implements<req::INC_ID_001> && implements<req::INC_ID_002> && implements<req::INC_SLEW_002> &&
              implements<req::INC_K_FAST_SLEW>);
void Device::put_factory_values(const ParameterGroup group) {
    if (group == ParameterGroup::communication) {
        const auto put = [this](const Field<std::uint32_t> entry, const std::optional<std::uint32_t>& value) {
            if (value.has_value()) {
                objects_.set(entry, *value);
            }
        };
        put(field::o1018_3_revision_number, factory_.revision);
        put(field::o1018_4_serial_number, factory_.serial_number);
        put(field::o1020_verify_configuration[1U], factory_.made_on);
        put(field::o1020_verify_configuration[2U], factory_.made_at);
    } else if (group == ParameterGroup::manufacturer) {
        objects_.set(field::o2000_can_slew_rate, suited_slew_rate(bit_rate_));
        objects_.set(field::o2400_calibrated_pitch_angle_data, factory_.calibration.pitch);
        objects_.set(field::o2401_calibrated_roll_angle_data, factory_.calibration.roll);
    } else {
        // no application parameters
    }
}

static_assert(implements<req::INC_T8> && implements<req::INC_RANGE_002> && implements<req::INC_FILTER_001> &&
              implements<req::INC_SLEW_002>);
void Device::restart(const Instant now) {
    namespace table = own::t_inc_t8;
    const auto* const range = table::find(factory_.range);
    span_ = AngleSpan{cell_or(range, &table::Row::lower, span_.lower), cell_or(range, &table::Row::upper, span_.upper)};
    received_.fill(false);
    results_.fill(undefined_signal());
    overdue_ = 0U;
    take_input_filter();
    take_settings();
    for (std::size_t function = 0U; function < function_count; ++function) {
        take_function(function);
    }
    if (std::uint32_t{node_.saved_tag()} != tag_of(bit_rate_)) {
        objects_.set(field::o2000_can_slew_rate, suited_slew_rate(bit_rate_));  // 2000h was stored at another bit rate
    }
    drive_slew_rate();
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

static_assert(implements<req::INC_START_001>);
void Device::booted(const Instant now) {
    // An error that outlasts a reset of communication does not begin anew, so that tell_errors() would let it start.
    const bool failed = node_.has_error(temperature_error) || node_.has_error(accelerometer_error);
    const bool keeps_out =
        failed && (objects_.get(field::o1029_error_behaviour[sensor_error_class]) != no_state_change);
    if (objects_.get(field::o5555_start_in_operational_mode) && !keeps_out) {
        node_.start_at(now);
    }
    tell_errors(now);
}

void Device::communication_failed(const bool, const Instant) {
    // nothing here depends on it: RPDOs that are late are asked for in forget_overdue()
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

static_assert(implements<req::INC_FILTER_001> && implements<req::INC_AVG_004> && implements<req::INC_K_SAMPLE_PERIOD>);
void Device::measure_due(const Instant now) noexcept {
    const bool samples = next_sample_ <= now;
    const bool filters = next_filter_ <= now;
    const bool had_failed = !inclination_.is_measuring();
    if (!samples && !filters) {
        return;
    }
    if (samples) {
        take_sample();
        next_sample_ = ((next_sample_ + sample_period) > now) ? (next_sample_ + sample_period) : (now + sample_period);
    }
    if (filters) {
        const Duration rate = milliseconds(objects_.get(field::o2052_angular_filter_rate));
        next_filter_ = ((next_filter_ + rate) > now) ? (next_filter_ + rate) : (now + rate);
    }
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
        publish_angles();  // nothing else was measured
    }
}

static_assert(implements<req::INC_ERR_006> && implements<req::INC_K_SENSOR_RANGE>);
bool Device::has_sensor_fault() const noexcept {
    return inputs_.accelerometer_fault || !is_measurement(inputs_.acceleration_x) ||
           !is_measurement(inputs_.acceleration_y) || !is_measurement(inputs_.acceleration_z);
}

static_assert(implements<req::INC_FV_007>);
void Device::take_sample() noexcept {
    if (has_sensor_fault()) {
        inclination_.fail();
    } else {
        inclination_.sample(Vector3{inputs_.acceleration_x, inputs_.acceleration_y, inputs_.acceleration_z}, settings_);
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

// No TPDO has to hear of changes: their type is fixed at 254, whose event is the timer (4.2.15).
void Device::publish() noexcept {
    publish_accelerations();
    publish_angles();
    publish_diagnostics();
}

static_assert(implements<req::INC_FV_001> && implements<req::INC_FV_002> && implements<req::INC_FV_003> &&
              implements<req::INC_FV_004> && implements<req::INC_FV_005> && implements<req::INC_ANGLE_001>);
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

static_assert(implements<req::INC_FOM_001> && implements<req::INC_T5> && implements<req::INC_FV_006> &&
              implements<req::INC_LATENCY_001> && implements<req::INC_GLOBAL_001> && implements<req::INC_GLOBAL_002>);
void Device::publish_diagnostics() noexcept {
    namespace merit = own::t_inc_t5;
    const auto* const row = merit::find(!inclination_.is_measuring(), is_temperature_outside(),
                                        inclination_.is_weightless(), inclination_.is_roll_unsure());
    const std::uint8_t worst = merit::rows[0U].state;
    objects_.set(field::o4020_angular_figure_of_merit, cell_or(row, &merit::Row::state, worst));
    objects_.set(field::o4010_angular_measurement_latency, whole_milliseconds(latency_ms()));
    if (!std::isnan(inputs_.sensor_temperature)) {
        objects_.set(field::o4060_sensor_temperature_data, count_value(inputs_.sensor_temperature, CountScale{}));
    }
    show_if_valid(supply_index, inputs_.supply_voltage);
    show_if_valid(processor_temperature_index, inputs_.processor_temperature);
}

/// A value that its object cannot hold is no measurement: the last one stays.
void Device::show_if_valid(const std::uint16_t index, const float value) noexcept {
    const auto entry = objects_.find(index, 0U);
    std::array<std::uint8_t, sizeof(float)> bytes{};
    write_le(MutableBytes{bytes}, 0U, sizeof(float), bit_cast<std::uint32_t>(value));
    if (entry.ok() && (objects_.check_value(entry.value(), ByteView{bytes}) == AbortCode::none)) {
        static_cast<void>(objects_.put(entry.value(), ByteView{bytes}));
    }
}

static_assert(implements<req::INC_RPDO_002>);
/// Once for each RPDO that becomes late: what is written afterwards counts.
void Device::forget_overdue() noexcept {
    const std::uint32_t overdue = node_.overdue_rpdos();
    if ((overdue & ~overdue_) != 0U) {
        received_.fill(false);
    }
    overdue_ = overdue;
}

static_assert(implements<req::INC_BIN_008> && implements<req::INC_BIN_009>);
void Device::run_functions() noexcept {
    forget_overdue();
    for (std::size_t function = 0U; function < function_count; ++function) {
        FunctionBlock& block = functions_[function];
        for (std::size_t input = 0U; input < block.inputs.size(); ++input) {
            block.inputs[input].source = signal_of(sources_[function][input]);
        }
        results_[function] = evaluate(block);
        objects_.set(field::o3000_binary_function_output_field_value[static_cast<std::uint8_t>(function + 1U)],
                     count_value(as_continuous(results_[function]), CountScale{}));
    }
}

static_assert(implements<req::INC_ERR_005> && implements<req::INC_ERR_006> && implements<req::INC_ERR_011>);
void Device::tell_errors(const Instant now) noexcept {
    tell_sensor_error(temperature_error, is_temperature_outside(), now);
    tell_sensor_error(accelerometer_error, !inclination_.is_measuring(), now);
}

void Device::tell_sensor_error(const ErrorId error, const bool present, const Instant now) noexcept {
    const bool begins = present && !node_.has_error(error);
    node_.set_error(error, present, now);
    if (begins) {
        node_.apply_error_behaviour(sensor_error_class, now);
    }
}

static_assert(implements<req::INC_FILTER_002> && implements<req::INC_FILTER_004>);
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
    settings_.euler = objects_.get(field::o2100_pitch_and_roll_angle_type) == 0U;
    settings_.gimbal_lock_cone = own::gimbal_lock_cone;
    settings_.least_gravity = own::least_gravity;
    inclination_.update(settings_);
}

void Device::restart_filters(const Instant now) noexcept {
    for (std::size_t angle = 0U; angle < angle_count; ++angle) {
        restart_filter(angle);
    }
    next_filter_ = now + milliseconds(objects_.get(field::o2052_angular_filter_rate));
}

void Device::restart_filter(const std::size_t angle) noexcept {
    const std::uint8_t sub = static_cast<std::uint8_t>(angle + 1U);
    filters_[angle].restart(filter_kind(sub), objects_.get(field::o2051_angular_filter_constant[sub]));
    if (inclination_.is_measuring()) {
        filters_[angle].add(inclination_.angles()[angle]);
    }
}

static_assert(implements<req::INC_T4>);
AngleFilterKind Device::filter_kind(const std::uint8_t subindex) const noexcept {
    using own::t_inc_t4::Filter;
    const std::uint8_t type = objects_.get(field::o2050_angular_filter_type[subindex]);
    switch (cell_or(own::t_inc_t4::find(type), &own::t_inc_t4::Row::filter, Filter::none)) {
        case Filter::moving_average:
            return AngleFilterKind::moving_average;
        case Filter::repeating:
            return AngleFilterKind::repeating;
        case Filter::none:
        default:
            return AngleFilterKind::none;
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

/// Reversed in sign where 2011h says so, in g.
float Device::given_acceleration(const std::uint8_t axis) const noexcept {
    const Vector3& sensed = inclination_.acceleration();
    const std::array<float, angle_count> axes{{sensed.x, sensed.y, sensed.z}};
    return reversed_if(objects_.get(field::o2011_accelerometer_data_inversion[axis]) != 0U, axes[axis - 1U]);
}

static_assert(implements<req::INC_RANGE_001> && implements<req::INC_RANGE_003> && implements<req::INC_FV_004>);
/// Filtered, in its range and reversed in sign where 2031h says so, in degrees.
float Device::given_angle(const std::size_t angle) const noexcept {
    const float measured = filters_[angle].output();
    const float ranged = (angle == gravity_tilt) ? measured : in_span(measured, span_);
    const std::uint8_t sub = static_cast<std::uint8_t>(angle + 1U);
    return reversed_if(objects_.get(field::o2031_angular_data_inversion[sub]) != 0U, ranged);
}

float Device::latency_ms() const noexcept {
    const std::uint16_t rate = objects_.get(field::o2052_angular_filter_rate);
    float slowest{0.0F};
    for (std::uint8_t sub = 1U; sub <= angle_count; ++sub) {
        const std::uint16_t samples = objects_.get(field::o2051_angular_filter_constant[sub]);
        slowest = std::fmax(slowest, angle_filter_delay_ms(filter_kind(sub), samples, rate));
    }
    const bool filtered = objects_.get(field::o2002_sensor_input_filter_enabled) != 0U;
    const float cut_off = static_cast<float>(objects_.get(field::o2003_input_filter_cut_off_frequency));
    return filtered ? (slowest + low_pass_delay_ms(cut_off)) : slowest;
}

static_assert(implements<req::INC_K_TEMPERATURE_LOW> && implements<req::INC_K_TEMPERATURE_HIGH>);
bool Device::is_temperature_outside() const noexcept {
    const float temperature = inputs_.sensor_temperature;
    const bool inside = (temperature >= own::sensor_temperature_low) && (temperature <= own::sensor_temperature_high);
    return !inside;  // NaN is not inside
}

Signal Device::acceleration_signal(const std::uint8_t axis) const noexcept {
    return inclination_.is_measuring() ? continuous_signal(given_acceleration(axis)) : undefined_signal();
}

Signal Device::angle_signal(const std::size_t angle) const noexcept {
    return inclination_.is_measuring() ? continuous_signal(given_angle(angle)) : undefined_signal();
}

static_assert(implements<req::INC_RPDO_001>);
Signal Device::received_signal(const std::size_t place) const noexcept {
    if (!received_[place]) {
        return undefined_signal();
    }
    const std::uint8_t sub = static_cast<std::uint8_t>(place + 1U);
    const ReceivedScale scale{objects_.get(field::o2501_rpdo_decimal_digits[sub]),
                              objects_.get(field::o2502_rpdo_offset[sub])};
    return continuous_signal(
        value_of_count(objects_.get(field::o2500_rpdo_received_message_process_value[sub]), scale));
}

static_assert(implements<req::INC_T1> && implements<req::INC_SIG_001> && implements<req::INC_SIG_002> &&
              implements<req::INC_SIG_005> && implements<req::INC_GLOBAL_003>);
Signal Device::signal_of(const std::uint8_t source) const noexcept {
    using Source = own::t_inc_t1::Signal;
    const Source chosen = cell_or(own::t_inc_t1::find(source), &own::t_inc_t1::Row::signal, Source::none);
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
            return std::isnan(inputs_.sensor_temperature) ? undefined_signal()
                                                          : continuous_signal(inputs_.sensor_temperature);
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

}  // namespace canproof::ax060805
