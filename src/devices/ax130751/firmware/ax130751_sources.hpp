// SPDX-License-Identifier: Apache-2.0
// Control sources of the AX130751: the value that a source and a number select, with its limits and state (1.3, Tables
// 4A, 4B and 5).
#pragma once

#include <array>

#include "devices/ax130751/firmware/ax130751_fields.hpp"
#include "devices/ax130751/firmware/block_signal.hpp"
#include "devices/ax130751/firmware/lookup_table.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/ax130751/enumerations.hpp"
#include "generated/ax130751/requirements.hpp"
#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

using generated::ax130751::Quantity;

/// Returns the row of the type in 6310h output type: kind and range of the output. An unknown type gives the row
/// "none".
const generated::ax130751::output_type::Row& output_type(const ObjectDictionary& objects, std::uint8_t output) noexcept;
/// Returns whether the digital output block drives the output.
bool is_digital(const ObjectDictionary& objects, std::uint8_t output) noexcept;

struct SourceRef {
    Quantity quantity{Quantity::none};
    std::uint8_t channel{0U};
};
/// Returns the quantity for a source and a number by the manual's Tables 4A and 4B; none for a pair that is not in
/// them.
SourceRef resolve(std::uint8_t source, std::uint8_t number) noexcept;

/// Holds the last chosen source and number, and the quantity that they select. The quantity is looked up when the
/// choice changes: this cache depends on the source and the number. It is also looked up when a bit of the cache has
/// flipped in memory, because otherwise the error would last until source or number is written.
class SourceChoice {
  public:
    static_assert(implements<req::AOR_SRC_012>);
    const SourceRef& follow(const std::uint8_t source, const std::uint8_t number) noexcept {
        if ((std::uint32_t{source} != source_) || (std::uint32_t{number} != number_) ||
            (std::uint32_t{check_} != check_of(ref_))) {
            source_ = source;
            number_ = number;
            ref_ = resolve(source, number);
            check_ = check_of(ref_);
        }
        return ref_;
    }
    /// Returns whether a source is chosen: it is not 0.
    bool is_chosen() const noexcept { return source_ != 0U; }
    const SourceRef& ref() const noexcept { return ref_; }

  private:
    static constexpr std::uint8_t not_yet = 0xFFU;  // nothing was looked up yet: no source has this number

    /// Returns a check byte, which changes when a single bit of `ref` changes.
    static constexpr std::uint8_t check_of(const SourceRef& ref) noexcept {
        return static_cast<std::uint8_t>(static_cast<std::uint32_t>(ref.quantity) ^ ref.channel);
    }

    std::uint8_t source_{not_yet};
    std::uint8_t number_{not_yet};
    SourceRef ref_{};
    std::uint8_t check_{0U};  ///< check_of(ref_), unless a bit of `ref_` or `check_` has flipped in memory
};

class Sources {
  public:
    explicit Sources(const ObjectDictionary& objects) noexcept : objects_{objects} {}

    /// Resets all states: no table and no logic block has a value until its next cycle. Limits need no reset: they are
    /// not used while there is no value. The network state needs none either: each cycle begins with set_network().
    void reset() noexcept;
    /// Sets the network faults. `overdue`: bit n for RPDO n + 1. `silent`: a heartbeat is missing or life guarding has
    /// failed.
    void set_network(std::uint8_t overdue, bool silent) noexcept;
    void set_lookup(std::uint8_t table, SignalState state, const LookupLimits& limits) noexcept;
    void set_logic(std::uint8_t block, SignalState state) noexcept;

    BlockSignal signal(const SourceRef& ref) const noexcept;
    /// Returns whether an interlock input, whose signal is `signal`, has a source that gives it no value: the block
    /// that is the source is off, or the number does not exist. The output of a math block that is off is 0 and valid,
    /// but it is no value for an interlock.
    bool lacks(const SourceChoice& choice, const BlockSignal& signal) const noexcept;
    /// Returns the signal without its limits, for callers that do not need them: computing the limits takes more time
    /// than the rest of the signal.
    BlockSignal reading(const SourceRef& ref) const noexcept;
    /// Returns only the lower limit, even when there is no value. It must not be called for a lookup table, whose
    /// limits depend on its points.
    double minimum(const SourceRef& ref) const noexcept;

  private:
    using Lower = generated::ax130751::value_limits::Lower;
    using Upper = generated::ax130751::value_limits::Upper;
    using Digits = generated::ax130751::value_limits::Digits;

    /// A source with its row in the manual's Table 5 and its decimal digits.
    struct Place {
        SourceRef ref{};
        const generated::ax130751::value_limits::Row* row{nullptr};
        std::uint8_t digits{0U};
    };

    /// The entries of received values that overdue RPDOs map: bit n for subindex n. Found once per cycle, because up
    /// to 90 inputs of blocks, outputs and relay ask in each cycle whether their source is overdue.
    struct OverdueEntries {
        std::uint32_t commands{0U};  ///< 7300h (AO Output Process Value)
        std::uint32_t states{0U};    ///< 6220h (DO Write State 1 Output Line)
        std::uint32_t extra{0U};     ///< 2500h (EC Extra Received Process Value)
    };

    struct KeptLimits {
        KeptPhysicalValue lower{};
        KeptPhysicalValue upper{};
    };

    Place place(const SourceRef& ref) const noexcept;
    std::uint8_t digits(Digits digits, std::uint8_t channel) const noexcept;
    double lower(Lower limit, std::uint8_t channel, std::uint8_t digits) const noexcept;
    double upper(Upper limit, std::uint8_t channel, std::uint8_t digits) const noexcept;
    double value(const SourceRef& ref, std::uint8_t digits) const noexcept;
    SignalState state(const SourceRef& ref) const noexcept;
    SignalState network_state(std::uint32_t overdue, std::uint8_t channel) const noexcept;
    void add_overdue(const MappingFields& mapping) noexcept;

    const ObjectDictionary& objects_;
    // Many blocks read the same quantities, which rarely change. These members are caches, not state: they depend on
    // the entry's integer and its digits, and each reading compares both. Each channel has its own caches.
    mutable std::array<KeptPhysicalValue, output_count> commands_{};
    mutable std::array<KeptPhysicalValue, output_count> field_values_{};
    mutable std::array<KeptPhysicalValue, output_count> feedbacks_{};
    mutable std::array<KeptPhysicalValue, extra_received_count> received_{};
    mutable std::array<KeptPhysicalValue, table_count> tables_{};
    mutable std::array<KeptPhysicalValue, logic_count> selections_{};
    mutable std::array<KeptPhysicalValue, math_count> calculations_{};
    mutable KeptTenths supply_{};
    mutable KeptTenths temperature_{};
    mutable std::array<KeptLimits, output_count> command_limits_{};
    mutable std::array<KeptLimits, output_count> field_value_limits_{};
    mutable std::array<KeptLimits, extra_received_count> received_limits_{};
    mutable std::array<KeptLimits, math_count> calculation_limits_{};
    // The results that the tables and logic blocks had in the last cycle.
    std::array<SignalState, table_count> lookup_states_{};
    std::array<LookupLimits, table_count> lookup_limits_{};
    std::array<SignalState, logic_count> logic_states_{};
    OverdueEntries overdue_{};
    bool silent_{false};
};

}  // namespace canproof::ax130751
