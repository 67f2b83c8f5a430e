// SPDX-License-Identifier: Apache-2.0
// The readings of the Scanner: from the inputs at the terminals to voltages and temperatures.

#include <cmath>
#include <limits>

#include "devices/ax188001/firmware/ax188001_scanner.hpp"
#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/objects.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"

namespace canproof::ax188001 {

namespace {

namespace own = generated::ax188001;
namespace field = generated::ax188001::field;

constexpr double microvolts_per_millivolt = 1000.0;
constexpr double millivolts_per_microvolt = 0.001;  // a multiplication takes half the time of a division
constexpr std::uint32_t filter_50_hz = 50U;
constexpr std::uint32_t filter_60_hz = 60U;

static_assert(implements<req::TCS_T_GAIN>);
constexpr ConverterCircuit make_circuit() noexcept {
    ConverterCircuit circuit{};
    for (const auto& row : own::converter_gain::rows) {
        circuit.gains[row.step] = ConverterGain{row.gain, static_cast<double>(row.full_scale_uv)};
    }
    static_assert(implements<req::TCS_K_CODES> && implements<req::TCS_K_GAIN_BACK> && implements<req::TCS_K_SETTLING>);
    circuit.codes = static_cast<double>(own::converter_codes);
    circuit.raise_fraction = static_cast<double>(own::gain_raise_fraction);
    circuit.settling_conversions = own::settling_conversions;
    return circuit;
}
const ConverterCircuit circuit = make_circuit();

// The number of conversions that a change from the highest gain to the lowest takes, with settling after each step. The
// module waits for them at start.
const std::size_t conversions_to_settle =
    1U + ((ConverterCircuit::gain_count - 1U) * std::size_t{own::settling_conversions});

static_assert(implements<req::TCS_T_REJECTION> && implements<req::TCS_IN_007> && implements<req::TCS_IN_023>);
double hum_left(const std::uint8_t filter, const std::uint8_t mains) noexcept {
    namespace table = own::hum_rejection;
    const table::FilterHz selected = (filter == filter_50_hz) ? table::FilterHz::hz_50 : table::FilterHz::hz_60;
    table::MainsHz frequency = table::MainsHz::none;
    if (mains == filter_50_hz) {
        frequency = table::MainsHz::hz_50;
    } else if (mains == filter_60_hz) {
        frequency = table::MainsHz::hz_60;
    } else {
        // every other value means that there is no hum
    }
    return static_cast<double>(cell_or(table::find(selected, frequency), &table::Row::left, 0.0F));
}

}  // namespace

static_assert(implements<req::TCS_IN_001> && implements<req::TCS_LIM_006>);
void Scanner::restart(const Inputs& inputs) noexcept {
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        converters_[channel].reset();
        for (DelayedFault& fault : faults_[channel]) {
            fault.clear();
        }
    }
    for (DelayedFault& fault : unit_faults_) {
        fault.clear();
    }
    hum_rises_ = true;
    for (std::size_t i = 0U; i < conversions_to_settle; ++i) {
        read(inputs);
    }
}

static_assert(implements<req::TCS_IN_005>);
void Scanner::read(const Inputs& inputs) noexcept {
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        converters_[channel].convert(input_uv(inputs, channel), circuit);
    }
    hum_rises_ = !hum_rises_;
    static_assert(implements<req::TCS_CJ_006> && implements<req::TCS_K_CJ_LOWEST> && implements<req::TCS_K_CJ_HIGHEST>);
    const auto cold_junction = static_cast<double>(inputs.cold_junction);
    const double limited =
        std::fmin(std::fmax(cold_junction, own::cold_junction_lowest_c), own::cold_junction_highest_c);
    static_assert(implements<req::TCS_CJ_007>);
    cold_junction_c_ = std::isnan(cold_junction) ? cold_junction : limited;
    cpu_temperature_c_ = static_cast<double>(inputs.cpu_temperature);
    supply_v_ = static_cast<double>(inputs.supply);
}

/// Returns the voltage at the converter in µV. The detection current pulls the input of a broken wire beyond the range
/// of every gain. Residual hum changes its sign from reading to reading, which is the worst case of a beat between hum
/// and readings.
static_assert(implements<req::TCS_IN_006>);
double Scanner::input_uv(const Inputs& inputs, const std::size_t channel) const noexcept {
    if (inputs.tc_open[channel]) {
        return std::numeric_limits<double>::infinity();
    }
    const double left = static_cast<double>(inputs.tc_hum[channel]) *
                        hum_left(objects_.get(field::o2020_adc_filter_frequency), inputs.mains_frequency);
    const double voltage = static_cast<double>(inputs.tc_microvolts[channel]);
    return hum_rises_ ? (voltage + left) : (voltage - left);
}

static_assert(implements<req::TCS_IN_025>);
bool Scanner::is_open(const std::size_t channel) const noexcept {
    const bool corrected = objects_.get(field::o2000_cj_auto_correct[subindex(channel)]) != 0U;
    return converters_[channel].is_open() || (corrected && std::isnan(cold_junction_c_));
}

void Scanner::change_filter() noexcept {
    for (GainRanging& converter : converters_) {
        converter.unsettle(circuit);
    }
}

static_assert(implements<req::TCS_IN_014>);
SensorType Scanner::sensor_type(const std::size_t channel) const noexcept {
    // 6110h sensor type accepts only the numbers of the enumeration (table TCS-T1).
    return static_cast<SensorType>(objects_.get(field::o6110_tc_sensor_type[subindex(channel)]));
}

std::uint8_t Scanner::gain(const std::size_t channel) const noexcept {
    return converters_[channel].gain(circuit);
}

static_assert(implements<req::TCS_CJ_003> && implements<req::TCS_IN_009> && implements<req::TCS_IN_010>);
double Scanner::converted_uv(const std::size_t channel) noexcept {
    const double measured = converters_[channel].microvolts();
    if (objects_.get(field::o2000_cj_auto_correct[subindex(channel)]) == 0U) {
        return measured;
    }
    Kept<double>& kept = compensations_[channel];
    const SensorType type = sensor_type(channel);
    if (!kept.is_of(type, cold_junction_c_)) {
        const double millivolts = reference_mv(thermocouple_curve(type), cold_junction_c_);
        kept = Kept<double>{type, cold_junction_c_, millivolts * microvolts_per_millivolt};
    }
    return measured + kept.value;
}

static_assert(implements<req::TCS_T1> && implements<req::TCS_CONV_011> && implements<req::TCS_K_RANGE_MARGIN>);
Scanner::Conversion Scanner::convert(const std::size_t channel, const double microvolts) noexcept {
    const SensorType type = sensor_type(channel);
    Kept<Conversion>& kept = conversions_[channel];
    if (kept.is_of(type, microvolts)) {
        return kept.value;
    }
    Conversion result{};
    static_assert(implements<req::TCS_CONV_006>);
    result.celsius = static_cast<float>(exact_celsius(thermocouple_curve(type), microvolts * millivolts_per_microvolt));
    namespace table = own::thermocouple_type;
    const auto* const range = table::find(type);
    const auto highest = static_cast<double>(cell_or(range, &table::Row::highest_uv, std::int32_t{0}));
    const auto lowest = static_cast<double>(cell_or(range, &table::Row::lowest_uv, std::int32_t{0}));
    result.above = microvolts > (highest + own::range_margin_uv);
    static_assert(implements<req::TCS_CONV_013>);
    result.below = microvolts < (lowest - own::range_margin_uv);
    kept = Kept<Conversion>{type, microvolts, result};
    return result;
}

}  // namespace canproof::ax188001
