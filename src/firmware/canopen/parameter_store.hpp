// Stored parameters: 1010h and 1011h on a memory in which a power cut at any byte leaves the old set or the new (CiA
// 301, 7.5.2.13).
//
// Two banks take turns. A save writes a whole new set with the next sequence number into the bank that is not in use;
// only its last bytes, the CRC, make it valid. Start-up uses the valid bank with the higher number, so that an
// interrupted save was never made.
#pragma once

#include "firmware/base/crc32.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof {

/// Groups as bits: 1 << ParameterGroup.
using ParameterGroups = std::uint32_t;
constexpr ParameterGroups no_groups = 0x00U;
constexpr ParameterGroups all_groups = 0x07U;
constexpr ParameterGroups group_bit(const ParameterGroup group) noexcept {
    return ParameterGroups{1U} << static_cast<std::uint32_t>(group);
}

/// What start-up found in the memory.
enum class StoredSet : std::uint8_t {
    empty,   ///< never saved
    valid,   ///<
    corrupt  ///< something was saved, but no bank is sound: defaults apply
};

/// What becomes of stored values that stood at their default, a base with the node-ID added, when the node-ID changes.
enum class StoredNodeId : std::uint8_t {
    holds,   ///< they stay as they were stored (CAN-CBX-AO412, 7.5.1)
    follows  ///< they get the new node-ID (AX130751 3.2.14, 3.2.15)
};

class ParameterStore {
  public:
    ParameterStore(ObjectDictionary& objects, NonVolatileMemory& memory, StoredNodeId stored_node_id) noexcept;

    /// Looks for the bank in use; call after power-on and before load().
    StoredSet open() noexcept;
    /// Puts the stored values of `groups` into the dictionary of the node `node_id`; groups that were never saved are
    /// left alone.
    void load(ParameterGroups groups, std::uint8_t node_id) noexcept;

    /// A write to 1010h or 1011h: `entry` says which groups, `value` must be the signature (else 08000020h). 06060000h
    /// when the memory failed; what was stored before is then still stored.
    AbortCode execute(const EntryRef& entry, std::uint32_t value) noexcept;

    /// A number of the device's, 0…31, that a save of the manufacturer parameters keeps with them: what it was made at.
    void mark_saves(const std::uint8_t mark) noexcept { mark_ = mark; }
    /// The mark of the manufacturer parameters that are stored.
    std::uint8_t saved_mark() const noexcept { return static_cast<std::uint8_t>(groups_ >> mark_shift); }

    /// Bytes of memory that this dictionary needs.
    std::size_t needed_size() const noexcept { return bank_count * bank_size(); }

  private:
    static constexpr std::size_t header_size = 16U;
    static constexpr std::size_t crc_size = 4U;
    static constexpr std::size_t bank_count = 2U;
    static constexpr std::uint32_t mark_shift = 3U;  ///< of the mark in the header's byte of groups
    using Header = std::array<std::uint8_t, header_size>;

    /// Writes bytes one behind the other and keeps their CRC; after a failure nothing more.
    class Writer {
      public:
        Writer(NonVolatileMemory& memory, const std::size_t at) noexcept : memory_{memory}, at_{at} {}

        void write(ByteView bytes) noexcept;
        void fail() noexcept { done_ = false; }
        bool done() const noexcept { return done_; }
        std::uint32_t crc() const noexcept { return crc_.value(); }

      private:
        NonVolatileMemory& memory_;
        std::size_t at_;
        Crc32 crc_{};
        bool done_{true};
    };

    std::size_t bank_size() const noexcept { return header_size + payload_size_ + crc_size; }
    std::size_t bank_address(const std::size_t bank) const noexcept { return bank * bank_size(); }
    /// Where the stored values of the bank in use begin.
    std::size_t payload() const noexcept { return bank_address(bank_) + header_size; }

    bool is_ours(const Header& header) const noexcept;
    bool is_intact(std::size_t bank) const noexcept;
    void use(std::size_t bank, const Header& header) noexcept;
    AbortCode write_set(ParameterGroups fresh, ParameterGroups kept) noexcept;
    void follow_node_id(const EntryRow& row, MutableBytes& value) const noexcept;
    void write_values(ParameterGroups fresh, Writer& to) const noexcept;
    void keep_value(const EntryRow& row, std::size_t from, Writer& to) const noexcept;

    ObjectDictionary& objects_;
    NonVolatileMemory& memory_;
    StoredNodeId stored_node_id_;
    std::uint8_t node_id_{0U};  ///< of the node as it was loaded last
    std::size_t payload_size_;  ///< bytes of all stored values
    std::uint8_t mark_{0U};     ///< of the next save
    std::size_t bank_{0U};      ///< the bank in use, and what its header says:
    std::uint32_t sequence_{0U};
    ParameterGroups groups_{no_groups};  ///< and the mark above them; none when nothing is stored
    std::uint8_t saved_node_id_{0U};     ///< of the node that saved
    bool in_use_{false};
};

}  // namespace canproof
