// Stored parameters: 1010h and 1011h on a memory in which a power cut at any byte leaves the old set or the new (CiA
// 301, 7.5.2.13).
//
// Two banks take turns. A save makes the bank that is not in use void, writes a whole new set with the next sequence
// number and a CRC into it, commits it by its marker and makes the other bank void. An interrupted save leaves a void
// bank and was never made; a bank that is not void and whose CRC is wrong is damaged, and then no stored set is used.
#pragma once

#include "firmware/base/commit_marker.hpp"
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

class ParameterStore {
  public:
    ParameterStore(ObjectDictionary& objects, NonVolatileMemory& memory) noexcept;

    /// Looks for the bank in use; call after power-on and before load().
    void open() noexcept;
    /// Puts the stored values of a group into the dictionary of the node `node_id`; a group that was never saved is
    /// left alone. A value that stood at its default, a base with the node-ID added, when it was saved does so again.
    void load(ParameterGroup group, std::uint8_t node_id) noexcept;
    /// A set was saved that open() or load() could not read: nothing of it counts any more, defaults apply.
    bool is_damaged() const noexcept { return damaged_; }

    /// A write to 1010h or 1011h: `entry` says which groups, `value` must be the signature (else 08000020h). 06060000h
    /// when the memory failed; what was stored before is then still stored.
    AbortCode execute(const EntryRef& entry, std::uint32_t value) noexcept;

    /// From now on each save of the manufacturer parameters keeps this number, 0…31, with them; the device chooses it.
    void tag_saves(const std::uint8_t tag) noexcept { tag_ = tag; }
    /// The tag of the manufacturer parameters that are stored.
    std::uint8_t saved_tag() const noexcept { return static_cast<std::uint8_t>(groups_ >> tag_shift); }

    /// Bytes of memory that this dictionary needs.
    std::size_t needed_size() const noexcept { return bank_count * bank_size(); }

  private:
    static constexpr std::size_t header_size = 16U;
    static constexpr std::size_t crc_size = 4U;
    static constexpr std::size_t bank_count = 2U;
    static constexpr std::uint32_t tag_shift = 3U;  ///< of the tag in the header's byte of groups
    using Header = std::array<std::uint8_t, header_size>;

    /// Writes bytes one behind the other and keeps their CRC; after a failure nothing more.
    class Writer {
      public:
        Writer(NonVolatileMemory& memory, const std::size_t at) noexcept : memory_{memory}, at_{at} {}

        /// The header counts as it will be once the bank is committed.
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
    /// Where the stored values of the bank in use begin.
    std::size_t payload() const noexcept { return bank_address(bank_) + header_size; }

    BankState inspect(std::size_t bank, Header& header) const noexcept;
    bool is_ours(const Header& header) const noexcept;
    bool is_intact(std::size_t bank) const noexcept;
    void use(std::size_t bank, const Header& header) noexcept;
    AbortCode write_set(ParameterGroups fresh, ParameterGroups kept) noexcept;
    void give_up() noexcept;
    bool write_marker(std::size_t bank, std::uint8_t marker) noexcept;
    void write_values(ParameterGroups fresh, Writer& to) const noexcept;
    void keep_value(const EntryRow& row, std::size_t from, Writer& to) const noexcept;

    ObjectDictionary& objects_;
    NonVolatileMemory& memory_;
    std::uint8_t node_id_{0U};  ///< of the node as it was loaded last
    std::size_t payload_size_;  ///< bytes of all stored values
    std::uint8_t tag_{0U};      ///< of the next save
    std::size_t bank_{1U};      ///< the bank in use, or the damaged one: the other takes the next save
    std::uint32_t sequence_{0U};
    ParameterGroups groups_{no_groups};  ///< and the tag above them; none when nothing is stored
    std::array<std::uint8_t, parameter_group_count> saved_node_ids_{};  ///< of the node that saved each group
    bool in_use_{false};
    bool damaged_{false};
};

}  // namespace canproof
