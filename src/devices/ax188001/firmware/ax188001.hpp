// SPDX-License-Identifier: Apache-2.0
// Axiomatic AX188001: scanner of two thermocouples (manual AX188001, chapters 1 and 3).
#pragma once

#include <array>
#include <optional>

#include "devices/ax188001/firmware/ax188001_scanner.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/ax188001/objects.hpp"
#include "generated/ax188001/signals.hpp"

namespace canproof::ax188001 {

using Outputs = generated::ax188001::Outputs;

/// Values of one unit, set in the factory (3.2.11). For a value that is absent, the device uses the one in the
/// requirements register.
struct FactoryData {
    std::optional<std::uint32_t> revision{};       ///< 1018h:3 revision number
    std::optional<std::uint32_t> serial_number{};  ///< 1018h:4 serial number
};

class Device final : private Application {
  public:
    Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept;

    /// Starts with the node-ID and bit rate that LSS stored, or with the shipped ones if LSS has stored none (3.1).
    void power_on(const Inputs& inputs, Instant now) noexcept;
    void receive(const Frame& frame, Instant now) noexcept;
    /// Sets the physical inputs from `now` on; measured values change with the next reading.
    void set_inputs(const Inputs& inputs, Instant now) noexcept;
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;

    const Outputs& outputs() const noexcept { return outputs_; }
    /// Returns the bit rate of the CAN controller in bit/s.
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }
    /// Returns the active node-ID; unconfigured_node_id when there is none.
    std::uint8_t node_id() const noexcept { return node_.node_id(); }
    NmtState state() const noexcept { return node_.state(); }
    NodeSettings settings() const noexcept { return node_.settings(); }
    /// Returns the node, for checks that change nothing.
    const Node& node() const noexcept { return node_; }
    const ObjectDictionary& objects() const noexcept { return objects_; }
    /// Returns the type that 6110h (sensor type) sets for channel 0 or 1.
    SensorType sensor_type(const std::size_t channel) const noexcept { return scanner_.sensor_type(channel); }

  private:
    AbortCode save(ParameterGroups saved) override;
    void after_write(const EntryRef& entry, Instant now) override;
    void put_factory_values(ParameterGroup group) override;
    void restart(Instant now) override;
    void booted(Instant now) override;
    void set_bit_rate(std::uint32_t bit_rate, Instant now) override;
    LssError store_configuration(const LssConfiguration& configuration) override;

    void advance_when_due(Instant now) noexcept;
    void scan_when_due(Instant now) noexcept;
    void obey_lasting_faults(Instant now) noexcept;
    void start_others_when_due(Instant now) noexcept;
    void tell_faults(Instant now) noexcept;
    void tell(ErrorId error, bool present, std::uint8_t reaction, Instant now) noexcept;
    void show_outputs() noexcept;

    alignas(std::uint32_t) std::array<std::uint8_t, generated::ax188001::image_size> image_{};
    ObjectDictionary objects_;
    PdoMemoryFor<generated::ax188001::compiled::tables> pdos_{};
    TransmitQueue& queue_;
    LssStore lss_store_;
    Node node_;
    Scanner scanner_;
    FactoryData factory_;
    Inputs inputs_{};
    Outputs outputs_{};
    std::uint32_t bit_rate_{0U};
    Instant next_scan_{never};
    Instant start_others_at_{never};
    std::uint8_t start_mode_{0U};  ///< the stored value of 5555h start in operational mode
};

}  // namespace canproof::ax188001
