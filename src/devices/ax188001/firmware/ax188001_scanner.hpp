// SPDX-License-Identifier: Apache-2.0
// The measuring part of the AX188001: from the terminals to field values, process values and faults (1.1 to 1.4). It
// reads parameters from the dictionary and writes measured values into it; the Device reports faults on the bus.
#pragma once

#include <array>
#include <limits>

#include "devices/ax188001/firmware/delayed_fault.hpp"
#include "devices/ax188001/firmware/gain_ranging.hpp"
#include "devices/ax188001/firmware/process_value.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/ax188001/enumerations.hpp"
#include "generated/ax188001/signals.hpp"
#include "generated/ax188001/written.hpp"

namespace canproof::ax188001 {

using Inputs = generated::ax188001::Inputs;
using generated::ax188001::SensorType;

constexpr std::size_t channel_count = 2U;

/// The faults of one channel (1.1).
enum class ChannelFault : std::uint8_t { open = 0U, high = 1U, low = 2U, shutdown = 3U };
constexpr std::size_t channel_fault_count = 4U;

/// The faults of the unit, FD1 to FD3 (1.4).
enum class UnitFault : std::uint8_t { cpu_temperature = 0U, over_voltage = 1U, under_voltage = 2U };
constexpr std::size_t unit_fault_count = 3U;

class Scanner {
  public:
    explicit Scanner(ObjectDictionary& objects) noexcept : objects_{objects} {}

    /// Restarts after the parameters were loaded: the converters settle on the voltages at the terminals, and all
    /// faults, reported or waiting, are cleared. The caller then calls evaluate().
    void restart(const Inputs& inputs) noexcept;
    /// Takes one reading of all inputs.
    void read(const Inputs& inputs) noexcept;
    /// Converts and evaluates the last reading with the present parameters.
    void evaluate(Instant now) noexcept;
    /// Converts and evaluates again the values that depend on the written parameter. `channel` (0 or 1) is used only
    /// if the parameter belongs to a channel.
    void reevaluate(generated::ax188001::Parameter written, std::size_t channel, Instant now) noexcept;
    /// Reports every waiting fault whose delay has ended, and updates 6150h (TC Status).
    void advance(Instant now) noexcept;
    /// Returns when the delay of the next waiting fault ends; never when no fault waits.
    Instant next_deadline() const noexcept { return next_deadline_; }

    bool told(const std::size_t channel, const ChannelFault fault) const noexcept {
        return faults_[channel][static_cast<std::size_t>(fault)].told();
    }
    bool told(const UnitFault fault) const noexcept { return unit_faults_[static_cast<std::size_t>(fault)].told(); }
    SensorType sensor_type(std::size_t channel) const noexcept;
    std::uint8_t gain(std::size_t channel) const noexcept;

  private:
    /// A voltage converted to a temperature, and whether this temperature is above or below the range of the sensor
    /// type. The limits are compared with the REAL32 that is also sent as field value.
    struct Conversion {
        float celsius{0.0F};
        bool above{false};
        bool below{false};
    };

    /// A cached value that depends on the sensor type and a number. Computing the value again is slow, because the FPU
    /// has no double precision.
    template <typename Value>
    struct Kept {
        SensorType type{SensorType::j};
        double of{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: empty
        Value value{};

        bool is_of(const SensorType wanted, const double number) const noexcept {
            return (type == wanted) && (of <= number) && (of >= number);
        }
    };

    /// Returns the sub-index of a channel; channels count from 0.
    static constexpr std::uint8_t subindex(const std::size_t channel) noexcept {
        return static_cast<std::uint8_t>(channel + 1U);
    }
    double input_uv(const Inputs& inputs, std::size_t channel) const noexcept;
    bool is_enabled(std::size_t channel) const noexcept;
    /// Returns whether a channel has no temperature: its circuit is open, or its compensation has no value.
    bool is_open(std::size_t channel) const noexcept;
    double converted_uv(std::size_t channel) noexcept;
    Conversion convert(std::size_t channel, double microvolts) noexcept;
    void change_filter() noexcept;
    Measurement evaluate_channel(std::size_t channel, Instant now) noexcept;
    void put_channel(std::size_t channel, std::uint32_t field_value_bits, std::int16_t process_value) noexcept;
    void judge_temperature(std::size_t channel, const Conversion& conversion, Instant now) noexcept;
    void evaluate_average() noexcept;
    void evaluate_cold_junction() noexcept;
    void evaluate_unit(Instant now) noexcept;
    void judge_unit(UnitFault fault, bool enabled, const FaultCondition& condition, Instant now) noexcept;
    void put_status() noexcept;
    void schedule() noexcept;

    DelayedFault& fault_of(const std::size_t channel, const ChannelFault fault) noexcept {
        return faults_[channel][static_cast<std::size_t>(fault)];
    }
    Duration channel_delay(std::size_t channel) const noexcept;
    Duration unit_delay(std::size_t fault) const noexcept;

    ObjectDictionary& objects_;
    std::array<GainRanging, channel_count> converters_{};
    /// The key is the temperature of the cold junction in °C; the value is in µV.
    std::array<Kept<double>, channel_count> compensations_{};
    /// The key is the voltage of the input in µV.
    std::array<Kept<Conversion>, channel_count> conversions_{};
    std::array<Measurement, channel_count> measurements_{};
    std::array<std::array<DelayedFault, channel_fault_count>, channel_count> faults_{};
    std::array<DelayedFault, unit_fault_count> unit_faults_{};
    double cold_junction_c_{0.0};
    double cpu_temperature_c_{0.0};
    double supply_v_{0.0};
    bool hum_rises_{true};
    Instant next_deadline_{never};
};

}  // namespace canproof::ax188001
