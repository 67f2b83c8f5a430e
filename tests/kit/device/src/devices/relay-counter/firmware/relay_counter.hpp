// SPDX-License-Identifier: Apache-2.0
// The RC-22: two relays, a counter, its errors, LSS, and a lamp.
#pragma once

#include <array>

#include "devices/relay-counter/firmware/edge_counter.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/node.hpp"
#include "generated/relay_counter/objects.hpp"
#include "generated/relay_counter/signals.hpp"

namespace canproof::relay_counter {

using Inputs = generated::relay_counter::Inputs;
using Outputs = generated::relay_counter::Outputs;

/// Data of one unit that are set in the factory: none yet.
struct FactoryData {};

class Device final : private Application {
  public:
    Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept;

    /// Starts with the node-ID and bit rate stored by LSS, or with those as shipped.
    void power_on(const Inputs& inputs, Instant now) noexcept;
    void receive(const Frame& frame, Instant now) noexcept;
    /// Sets the physical inputs from `now` on.
    void set_inputs(const Inputs& inputs, Instant now) noexcept;
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;

    const Outputs& outputs() const noexcept { return outputs_; }
    /// Returns the bit rate of the CAN controller in bit/s.
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }
    /// Returns the node-ID, or unconfigured_node_id when there is none.
    std::uint8_t node_id() const noexcept { return node_.node_id(); }
    NmtState state() const noexcept { return node_.state(); }
    const ObjectDictionary& objects() const noexcept { return objects_; }
    /// Returns the node, for checks that change nothing.
    const Node& node() const noexcept { return node_; }

  private:
    AbortCode check_access(const EntryRef& entry) override;
    AbortCode before_write(const EntryRef& entry, ByteView value) override;
    void after_write(const EntryRef& entry, Instant now) override;
    void put_factory_values(ParameterGroup group) override;
    void restart(Instant now) override;
    void booted(Instant now) override;
    void communication_failed(bool failed, Instant now) override;
    void set_bit_rate(std::uint32_t bit_rate, Instant now) override;
    LssError store_configuration(const LssConfiguration& configuration) override;

    void tell_errors(Instant now) noexcept;
    void show_state() noexcept;
    void show_count() noexcept;

    std::array<std::uint8_t, generated::relay_counter::image_size> image_{};
    ObjectDictionary objects_;
    PdoMemoryFor<generated::relay_counter::compiled::tables> pdos_{};
    LssStore lss_store_;
    Node node_;
    Inputs inputs_{};
    Outputs outputs_{};
    EdgeCounter counter_{};
    std::uint32_t bit_rate_{0U};
};

}  // namespace canproof::relay_counter
