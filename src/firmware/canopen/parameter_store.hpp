// SPDX-License-Identifier: Apache-2.0
// Stored parameters: 1010h store parameters and 1011h restore defaults. A power cut at any byte leaves the old set or
// the new one (CiA 301, 7.5.2.13).
//
// Two banks alternate. A save marks the unused bank void and writes a whole new set into it, with the next sequence
// number and a CRC. Then it commits the new bank by its marker and marks the other bank void. A save that is
// interrupted before it commits the new bank leaves this bank void and has no effect. A committed bank with a wrong CRC
// is damaged; then no stored set is used.
#pragma once

#include "firmware/base/commit_marker.hpp"
#include "firmware/base/crc32.hpp"
#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof {

/// Parameter groups as bits: bit n is the group with number n of ParameterGroup.
using ParameterGroups = std::uint32_t;
constexpr ParameterGroups no_groups = 0x00U;
constexpr ParameterGroups all_groups = 0x07U;
constexpr ParameterGroups group_bit(const ParameterGroup group) noexcept {
    return ParameterGroups{1U} << static_cast<std::uint32_t>(group);
}
constexpr bool has_group(const ParameterGroups groups, const ParameterGroup group) noexcept {
    return (groups & group_bit(group)) != no_groups;
}

class ParameterStore {
  public:
    ParameterStore(ObjectDictionary& objects, NonVolatileMemory& memory) noexcept;

    /// Searches for the valid bank. The node calls it at power-on and at NMT reset node, before load().
    void open() noexcept;
    /// Puts the stored values of a group into the dictionary of the node `node_id`; a group that was never saved keeps
    /// its defaults. A COB-ID that was saved with the identifier of its default follows the new node-ID, if the
    /// default includes the node-ID.
    void load(ParameterGroup group, std::uint8_t node_id) noexcept;
    /// Returns whether a saved set exists that the last open() or a load() after it could not read. None of its values
    /// may then be used; the defaults apply.
    bool is_damaged() const noexcept { return damaged_; }

    /// Executes a write to 1010h (store) or 1011h (restore). `entry` selects the groups. Returns 08000020h when `value`
    /// is not the signature of the object ("save" or "load"). Returns 06060000h when the memory fails or is too small;
    /// the set stored before then remains valid. Returns AbortCode::none on success.
    AbortCode execute(const EntryRef& entry, std::uint32_t value) noexcept;
    /// Returns the groups that `entry`, a sub-index of 1010h (store) or 1011h (restore), selects. Sub-index 1 selects
    /// all groups, 2 the communication parameters, and 3 those of the application. In an object without sub-index 4,
    /// sub-index 3 selects those of the manufacturer, as every other sub-index does.
    ParameterGroups groups_of(const EntryRef& entry) const noexcept;

    /// Sets the tag: a number, 0…31, that each later save stores together with the manufacturer parameters. The device
    /// chooses the meaning of the tag.
    void tag_saves(const std::uint8_t tag) noexcept { tag_ = tag; }
    /// Returns the tag of the last save of the manufacturer parameters, also after a restore; 0 if there was no such
    /// save or if no stored set is readable.
    std::uint8_t saved_tag() const noexcept { return static_cast<std::uint8_t>(groups_ >> tag_shift); }

    /// Returns the number of bytes of memory that this dictionary needs.
    std::size_t needed_size() const noexcept { return bank_count * bank_size(); }

  private:
    static constexpr std::size_t header_size = 16U;
    static constexpr std::size_t crc_size = 4U;
    static constexpr std::size_t bank_count = 2U;
    /// Position of the tag's lowest bit in the header byte of the groups. The groups are bits 0 to 2 of this byte.
    static constexpr std::uint32_t tag_shift = 3U;
    using Header = std::array<std::uint8_t, header_size>;

    /// Writes consecutive bytes and computes their CRC; writes nothing more after a failure.
    class Writer {
      public:
        Writer(NonVolatileMemory& memory, const std::size_t at) noexcept : memory_{memory}, at_{at} {}

        /// Writes the header with the void marker; its CRC is computed with the committed marker.
        void write_header(Header header) noexcept;
        void write(const ByteView bytes) noexcept {
            crc_.add(bytes);
            put(bytes);
        }
        void fail() noexcept { done_ = false; }
        bool done() const noexcept { return done_; }
        std::uint32_t crc() const noexcept { return crc_.value(); }

      private:
        void put(ByteView bytes) noexcept;

        NonVolatileMemory& memory_;
        std::size_t at_;
        Crc32 crc_{};
        bool done_{true};
    };

    std::size_t bank_size() const noexcept { return header_size + payload_size_ + crc_size; }
    std::size_t bank_address(const std::size_t bank) const noexcept { return bank * bank_size(); }
    /// Returns the address of the stored values of the bank in use.
    std::size_t payload() const noexcept { return bank_address(bank_) + header_size; }

    BankState inspect(std::size_t bank, Header& header) const noexcept;
    bool is_ours(const Header& header) const noexcept;
    bool is_intact(std::size_t bank) const noexcept;
    void use(std::size_t bank, const Header& header) noexcept;
    AbortCode write_set(ParameterGroups fresh, ParameterGroups kept) noexcept;
    void give_up() noexcept;
    void follow_node_id(const EntryRow& row, std::uint8_t saved_node_id) noexcept;
    bool write_marker(std::size_t bank, std::uint8_t marker) noexcept;
    bool commit_bank(std::size_t to_bank) noexcept;
    void write_values(ParameterGroups fresh, Writer& to) const noexcept;
    void keep_value(const EntryRow& row, std::size_t from, Writer& to) const noexcept;

    ObjectDictionary& objects_;
    NonVolatileMemory& memory_;
    std::uint8_t node_id_{0U};  ///< node-ID of the last load()
    std::size_t payload_size_;  ///< length of all stored values together, in bytes
    std::uint8_t tag_{0U};      ///< tag of the next save, see tag_saves()
    std::size_t bank_{1U};      ///< the bank in use, or the damaged one: the next save uses the other
    std::uint32_t sequence_{0U};
    /// The saved groups in the low three bits, the tag above them; 0 when there is no readable set.
    ParameterGroups groups_{no_groups};
    std::array<std::uint8_t, parameter_group_count> saved_node_ids_{};  ///< node-ID at the save of each group
    bool in_use_{false};
    bool damaged_{false};
};

}  // namespace canproof
