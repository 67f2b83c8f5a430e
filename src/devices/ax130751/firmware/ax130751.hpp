// SPDX-License-Identifier: Apache-2.0
// Axiomatic AX130751 and AX130771: two universal outputs and a relay on CANopen, with ten lookup tables, three logic
// and four math blocks (manual AX130751, chapters 1, 3 and 4). The part numbers differ in isolation and housing; the
// firmware is the same.
#pragma once

#include <array>
#include <optional>

#include "devices/ax130751/firmware/ax130751_blocks.hpp"
#include "devices/ax130751/firmware/ax130751_first_point.hpp"
#include "devices/ax130751/firmware/ax130751_output.hpp"
#include "devices/ax130751/firmware/ax130751_relay.hpp"
#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "devices/ax130751/firmware/ax130751_supervision.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/node.hpp"

namespace canproof::ax130751 {

/// Values of one unit, set in the factory (3.2.11, 3.2.12). For a value that is absent, the device uses the one in the
/// requirements register.
struct FactoryData {
    std::optional<std::uint32_t> revision{};       ///< 1018h:3 revision number
    std::optional<std::uint32_t> serial_number{};  ///< 1018h:4 serial number
    std::optional<std::uint32_t> made_on{};        ///< 1020h:1 verify configuration, date
    std::optional<std::uint32_t> made_at{};        ///< 1020h:2 verify configuration, time
};

class Device final : private Application {
  public:
    Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept;

    /// Starts with the stored node-ID and bit rate, or with the shipped ones if nothing is stored. Both LSS and a write
    /// to 1010h (store parameters) store them. The write takes the values from 5B50h (change baud rate) and 5B51h
    /// (change node-ID).
    void power_on(const Inputs& inputs, Instant now) noexcept;
    void receive(const Frame& frame, Instant now) noexcept;
    /// Sets the physical inputs from `now` on; the blocks use them in their next cycle.
    void set_inputs(const Inputs& inputs, Instant now) noexcept;
    /// Runs every cycle that is due: at most one for each millisecond since the last call. After a long gap between two
    /// calls, the call takes correspondingly long.
    void advance(Instant now) noexcept;
    Instant next_deadline() const noexcept;

    const Outputs& outputs() const noexcept { return outputs_; }
    const ObjectDictionary& objects() const noexcept { return objects_; }
    std::uint32_t bit_rate() const noexcept { return bit_rate_; }
    std::uint8_t node_id() const noexcept { return node_.node_id(); }
    NmtState state() const noexcept { return node_.state(); }
    NodeSettings settings() const noexcept { return node_.settings(); }
    /// Returns the node, for checks that change nothing.
    const Node& node() const noexcept { return node_; }

  private:
    AbortCode before_write(const EntryRef& entry, ByteView value) override;
    AbortCode save(ParameterGroups saved) override;
    void after_write(const EntryRef& entry, Instant now) override;
    void put_factory_values(ParameterGroup group) override;
    void restart(Instant now) override;
    void booted(Instant now) override;
    void set_bit_rate(std::uint32_t bit_rate, Instant now) override;
    LssError store_configuration(const LssConfiguration& configuration) override;

    void run_cycle(Instant now) noexcept;
    bool run_blocks(Instant now) noexcept;
    void watch_network(Instant now) noexcept;
    void tell_errors(Instant now) noexcept;
    void wake(Instant now) noexcept;
    Instant next_change() const noexcept;
    void take_type(std::uint8_t output) noexcept;
    void follow_minima(const generated::ax130751::Written& change) noexcept;
    std::uint32_t wanted_bit_rate() const noexcept;
    void show_bit_rate() noexcept;
    void show_node_id() noexcept;

    alignas(std::uint32_t) std::array<std::uint8_t, generated::ax130751::image_size> image_{};
    ObjectDictionary objects_;
    LssStore lss_store_;
    PdoMemoryFor<generated::ax130751::compiled::tables> pdos_{};
    Node node_;
    FactoryData factory_;
    Inputs inputs_{};
    Outputs outputs_{};
    LssConfiguration kept_{};        ///< the stored settings for the next power-on
    LssConfiguration lss_stored_{};  ///< the settings at power-on, or those that LSS has stored since
    std::uint32_t bit_rate_{0U};

    // The blocks, in the order in which a cycle evaluates them.
    Supervision supervision_{};
    Sources sources_;
    std::array<FirstPoint, table_count> first_points_{};
    std::array<TableBlock, table_count> tables_{};
    std::array<SelectionBlock, logic_count> selections_{};
    std::array<CalculationBlock, math_count> calculations_{};
    std::array<UniversalOutput, output_count> universal_;
    RelayOutput relay_;

    std::array<std::uint16_t, output_count> types_{};  ///< last applied value of 6310h output type
    Instant epoch_{};                                  ///< cycles begin at whole multiples of cycle_time after this
    Instant next_cycle_{never};
    Instant called_{};  ///< the last call of advance(), or the power-on
    std::uint8_t overdue_{0U};
    bool silent_{false};
    bool runs_{false};           ///< the node was operational at the last call of watch_network()
    bool has_left_{false};       ///< the node has left operational since the last cycle
    bool starts_itself_{false};  ///< the stored value of 5555h start in operational mode
    /// The last cycle changed nothing. After two such cycles the blocks are not evaluated until something changes. The
    /// result of a cycle depends on frames, inputs and writes, each of which calls wake(). It also depends on the state
    /// that watch_network() reads, on the result of run_blocks(), and on the times in next_change().
    bool was_quiet_{false};
};

}  // namespace canproof::ax130751
