// SPDX-License-Identifier: Apache-2.0
// esd CAN-CBX-AO412: four analog outputs of 12 bit and sign (manual CBX-AO412, chapters 3 and 7).
#pragma once

#include <array>
#include <optional>

#include "devices/cbx-ao412/firmware/voltage_output.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/cbx_ao412/objects.hpp"
#include "generated/cbx_ao412/signals.hpp"
#include "generated/cbx_ao412/tables.hpp"

namespace canproof::cbx_ao412 {

using Inputs = generated::cbx_ao412::Inputs;
using Outputs = generated::cbx_ao412::Outputs;

constexpr std::uint32_t output_count = 4U;

/// A version string of a unit in ASCII, padded with zeros.
using VersionText = std::array<std::uint8_t, 8U>;

/// Values of one unit, set in the factory (7.9.8, 7.9.9, 7.9.18, 7.11, 7.12.2). For an empty text or an absent number,
/// the device uses the one in the requirements register.
struct FactoryData {
    VersionText hardware_version{};                ///< 1009h hardware version
    VersionText software_version{};                ///< 100Ah software version
    std::optional<std::uint32_t> software_date{};  ///< 1F52h:1 software date, days since 1984-01-01
    std::optional<std::uint32_t> software_time{};  ///< 1F52h:2 software time, ms since midnight
    std::optional<std::uint32_t> revision{};       ///< 1018h:3 revision number, major and minor
    std::optional<std::uint32_t> serial_number{};  ///< 1018h:4 serial number, lot letters with bit 7 set, then BCD
    std::array<std::int16_t, output_count> offset{};
    std::array<std::int16_t, output_count> gain{};
};

class Device final : private Application {
  public:
    Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept;

    /// Reads the coding switches and starts. With an invalid node-ID the node is not switched on: it stays in
    /// initialising, where it sends nothing, and only the LEDs work.
    void power_on(const Inputs& inputs, Instant now) noexcept;
    void receive(const Frame& frame, Instant now) noexcept;
    /// Sets the physical inputs from `now` on. The switches are read at power-on only.
    void set_inputs(const Inputs& inputs, Instant now) noexcept;
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;

    const Outputs& outputs() const noexcept { return outputs_; }
    /// Returns the bit rate (in bit/s) that the manual's Table 11 assigns to the position of the switch at power-on.
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }
    std::uint8_t node_id() const noexcept { return node_id_; }
    NmtState state() const noexcept { return runs_ ? node_.state() : NmtState::initialising; }
    NodeSettings settings() const noexcept { return node_.settings(); }
    /// Returns the node, for checks that change nothing.
    const Node& node() const noexcept { return node_; }
    const ObjectDictionary& objects() const noexcept { return objects_; }

  private:
    /// The setting of an output: if `on` is true, a value in the unit of 6411h write analogue output; otherwise 0 V,
    /// whatever the calibration.
    struct Driven {
        bool on{false};
        std::int16_t value{0};
    };

    AbortCode check_access(const EntryRef& entry) override;
    void after_write(const EntryRef& entry, Instant now) override;
    void put_factory_values(ParameterGroup group) override;
    void restart(Instant now) override;
    void booted(Instant now) override;
    void communication_failed(bool failed, Instant now) override;

    void put_version(std::uint16_t index, const VersionText& text) noexcept;
    /// Returns whether the software or a part of the hardware has failed.
    bool has_internal_fault() const noexcept { return inputs_.internal_fault || inputs_.hardware_fault; }
    void watch_internal_faults(Instant now) noexcept;
    void set_failed(bool communication, bool internal) noexcept;
    void command_outputs() noexcept;
    /// Sets output `number` (1…4) to `value`, in the unit of 6411h (Write Analogue Output 16-Bit), until the next
    /// command.
    void command_output(std::uint8_t number, std::int16_t value) noexcept;
    /// Sets the voltage of an output from its setting and the present calibration.
    void drive_output(std::uint8_t number) noexcept;
    void apply_error_mode(std::uint8_t number) noexcept;
    void drive_leds(Instant now) noexcept;
    bool show(generated::cbx_ao412::IndicatorState state, Duration shift, Instant now) noexcept;
    generated::cbx_ao412::IndicatorState status_indicator() const noexcept;
    generated::cbx_ao412::IndicatorState can_error_indicator() const noexcept;

    alignas(std::uint32_t) std::array<std::uint8_t, generated::cbx_ao412::image_size> image_{};
    ObjectDictionary objects_;
    PdoMemoryFor<generated::cbx_ao412::compiled::tables> pdos_{};
    Node node_;
    FactoryData factory_;
    Inputs inputs_{};
    Outputs outputs_{};
    std::array<Driven, output_count> driven_{};
    Instant next_led_change_{never};
    std::uint32_t bit_rate_{0U};
    std::uint8_t node_id_{0U};
    bool runs_{false};
    bool communication_failed_{false};
    bool failed_{false};
    bool internal_fault_shown_{false};
};

}  // namespace canproof::cbx_ao412
