// SPDX-License-Identifier: Apache-2.0
// Axiomatic AX060805, AX060835, AX060840, AX060841: triaxial inclinometer (manual AX060805, chapters 2 to 4). The part
// numbers differ in sensor and housing; the firmware is the same.
#pragma once

#include <array>
#include <optional>

#include "devices/ax060805/firmware/angle_filter.hpp"
#include "devices/ax060805/firmware/angle_range.hpp"
#include "devices/ax060805/firmware/binary_function.hpp"
#include "devices/ax060805/firmware/inclination.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/ax060805/objects.hpp"
#include "generated/ax060805/signals.hpp"
#include "generated/ax060805/tables.hpp"

namespace canproof::ax060805 {

using Inputs = generated::ax060805::Inputs;
using Outputs = generated::ax060805::Outputs;
using AngleConfiguration = generated::ax060805::angle_configuration::Range;

constexpr std::size_t function_count = 10U;
constexpr std::size_t received_count = 3U;

/// Values of one unit, set in the factory (3.5, 3.7, 4.2.11, 4.2.12). For a value that is absent, the device uses the
/// one in the requirements register.
struct FactoryData {
    std::optional<std::uint32_t> revision{};       ///< 1018h:3 revision number
    std::optional<std::uint32_t> serial_number{};  ///< 1018h:4 serial number
    std::optional<std::uint32_t> made_on{};        ///< 1020h:1 verify configuration, date
    std::optional<std::uint32_t> made_at{};        ///< 1020h:2 verify configuration, time
    /// 2400h (Calibrated Pitch Angle Data), -90 to 90, and 2401h (Calibrated Roll Angle Data), -180 to 180, in degrees.
    /// The caller checks these ranges.
    PitchRoll calibration{};
    AngleConfiguration range{AngleConfiguration::half_turns};
};

class Device final : private Application {
  public:
    Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept;

    /// Starts with the node-ID and bit rate that LSS stored, or with the shipped ones if LSS has stored none.
    void power_on(const Inputs& inputs, Instant now) noexcept;
    void receive(const Frame& frame, Instant now) noexcept;
    /// Sets the physical inputs from `now` on. The state of the CAN controller takes effect immediately. All other
    /// inputs take effect with the next sample of the sensor or at reset node.
    void set_inputs(const Inputs& inputs, Instant now) noexcept;
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;

    const Outputs& outputs() const noexcept { return outputs_; }
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }
    std::uint8_t node_id() const noexcept { return node_.node_id(); }
    NmtState state() const noexcept { return node_.state(); }
    NodeSettings settings() const noexcept { return node_.settings(); }
    /// Returns the node, for checks that change nothing.
    const Node& node() const noexcept { return node_; }
    const ObjectDictionary& objects() const noexcept { return objects_; }

  private:
    AbortCode before_write(const EntryRef& entry, ByteView value) override;
    AbortCode save(ParameterGroups saved) override;
    void after_write(const EntryRef& entry, Instant now) override;
    void put_factory_values(ParameterGroup group) override;
    void restart(Instant now) override;
    void booted(Instant now) override;
    void set_bit_rate(std::uint32_t bit_rate, Instant now) override;
    LssError store_configuration(const LssConfiguration& configuration) override;

    // The functions that process a sample, roughly in the order of their calls.
    void restart_sensor(Instant now) noexcept;
    void measure_due(Instant now) noexcept;
    void take_sample() noexcept;
    void pass_filters(bool sampled, bool timed) noexcept;
    void publish() noexcept;
    void publish_accelerations() noexcept;
    void publish_angles() noexcept;
    void publish_diagnostics() noexcept;
    void run_functions() noexcept;
    void forget_overdue() noexcept;
    void tell_errors(Instant now) noexcept;
    void tell_sensor_error(ErrorId error, bool present, Instant now) noexcept;
    void obey_lasting_errors(Instant now) noexcept;

    void take_input_filter() noexcept;
    void take_settings() noexcept;
    void restart_filters(Instant now) noexcept;
    void restart_filter(std::size_t angle) noexcept;
    void take_function(std::size_t function) noexcept;
    void obey_auto_null(Instant now) noexcept;
    void use_bit_rate(std::uint32_t bit_rate) noexcept;
    void drive_slew_rate() noexcept;

    Signal signal_of(std::uint8_t source) const noexcept;
    Signal acceleration_signal(std::uint8_t axis) const noexcept;
    Signal angle_signal(std::size_t angle) const noexcept;
    Signal received_signal(std::size_t place) const noexcept;
    float given_angle(std::size_t angle) const noexcept;
    float given_acceleration(std::uint8_t axis) const noexcept;
    float latency_ms() const noexcept;
    AngleFilterKind filter_kind(std::uint8_t subindex) const noexcept;
    bool is_temperature_outside() const noexcept;
    bool has_sensor_fault() const noexcept;
    void show_if_valid(std::uint16_t index, float value) noexcept;

    alignas(std::uint32_t) std::array<std::uint8_t, generated::ax060805::image_size> image_{};
    ObjectDictionary objects_;
    LssStore lss_store_;
    PdoMemoryFor<generated::ax060805::compiled::tables> pdos_{};
    Node node_;
    FactoryData factory_;
    Inputs inputs_{};
    Inputs sampled_{};  ///< the inputs at the last sample; all measured values are computed from them
    Outputs outputs_{};
    std::uint32_t bit_rate_{0U};

    InclinationSettings settings_{};
    AngleSpan span_{};
    Inclination inclination_{};
    std::array<AngleFilter, angle_count> filters_{};
    std::array<std::array<std::uint8_t, 2U>, function_count> sources_{};
    std::array<FunctionBlock, function_count> functions_{};
    std::array<Signal, function_count> results_{};
    std::array<bool, received_count> received_{};
    std::uint32_t overdue_{0U};  ///< bit n: RPDO n + 1 was overdue at the last check
    Instant next_sample_{never};
    Instant next_filter_{never};
    bool starts_itself_{false};  ///< the stored value of 5555h start in operational mode
};

}  // namespace canproof::ax060805
