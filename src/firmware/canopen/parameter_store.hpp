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
    AbortCode execute(const EntryRef& entry, ByteView value) noexcept;

    /// Bytes of memory that this dictionary needs.
    std::size_t needed_size() const noexcept { return 2U * bank_size(); }

  private:
    struct Header {
        std::uint32_t magic{0U};
        std::uint32_t layout{0U};
        std::uint32_t sequence{0U};
        ParameterGroups groups{no_groups};
        std::uint8_t node_id{0U};  ///< of the node that saved
    };
    static constexpr std::size_t header_size = 16U;
    static constexpr std::size_t crc_size = 4U;
    static constexpr std::size_t bank_count = 2U;

    std::size_t bank_size() const noexcept { return header_size + payload_size_ + crc_size; }
    std::size_t bank_address(const std::size_t bank) const noexcept { return bank * bank_size(); }

    Header read_header(std::size_t bank) const noexcept;
    bool is_blank(std::size_t bank) const noexcept;
    bool is_sound(std::size_t bank, const Header& header) const noexcept;
    AbortCode write_set(ParameterGroups fresh, ParameterGroups kept) noexcept;
    void follow_node_id(const EntryRef& entry, MutableBytes value) const noexcept;
    bool copy_values(std::size_t to_bank, ParameterGroups fresh, Crc32& crc) noexcept;
    bool write_checked(std::size_t at, ByteView bytes, Crc32& crc) noexcept;

    ObjectDictionary& objects_;
    NonVolatileMemory& memory_;
    std::size_t payload_size_;  ///< bytes of all stored values
    StoredNodeId stored_node_id_;
    std::uint8_t node_id_{0U};  ///< of the node as it was loaded last
    std::size_t bank_{0U};      ///< the bank in use
    Header current_{};          ///< its header; no groups when nothing is stored
    bool in_use_{false};
};

}  // namespace canproof
