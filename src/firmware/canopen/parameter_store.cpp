#include "firmware/canopen/parameter_store.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/sequence_number.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

using generated::canopen::restore_signature;
using generated::canopen::store_signature;

constexpr std::uint32_t store_index = 0x1010U;
constexpr std::uint32_t bank_magic = 0x53504F43U;  // "COPS" in memory
constexpr std::size_t longest_value = 64U;         // of those that are stored
constexpr std::size_t piece_size = 16U;            // a bank is checked and copied in pieces, none shorter than a number
// Fields of a bank's header.
constexpr std::size_t magic_at = 0U;
constexpr std::size_t layout_at = 4U;
constexpr std::size_t sequence_at = 8U;
constexpr std::size_t groups_at = 12U;
constexpr std::size_t node_id_at = 13U;

template <std::size_t at, std::size_t size>
std::uint32_t number_at(const std::array<std::uint8_t, size>& bytes) noexcept {
    return static_cast<std::uint32_t>(field_le<at, sizeof(std::uint32_t)>(bytes));
}

/// CiA 301 has application parameters at 3 and manufacturer ones from 4 on (7.5.2.13). A list that ends at 3 has the
/// latter there: its device has no application parameters (AX060805, 4.2.7).
constexpr ParameterGroups groups_of(const std::uint8_t subindex, const bool ends_at_3) noexcept {
    switch (subindex) {
        case 1U:
            return all_groups;
        case 2U:
            return group_bit(ParameterGroup::communication);
        case 3U:
            return group_bit(ends_at_3 ? ParameterGroup::manufacturer : ParameterGroup::application);
        default:
            return group_bit(ParameterGroup::manufacturer);
    }
}

/// The stored entries, one after the other in dictionary order.
class StoredEntries {
  public:
    explicit StoredEntries(const DictionaryTables& tables) noexcept : tables_{tables} {}

    /// Goes to the next one, from none to the first; false behind the last.
    bool next() noexcept;
    const EntryRef& entry() const noexcept { return entry_; }
    ParameterGroups group() const noexcept { return group_bit(parameter_group(entry_.index)); }
    /// Where its value stands in the payload.
    std::size_t offset() const noexcept { return end_ - entry_.row->size; }
    /// Bytes of the values up to this one.
    std::size_t end() const noexcept { return end_; }

  private:
    const DictionaryTables& tables_;
    std::size_t object_{0U};
    std::size_t position_{0U};  ///< among the object's entries
    std::size_t end_{0U};
    EntryRef entry_{};
};

bool StoredEntries::next() noexcept {
    while (object_ < tables_.objects.count) {
        const ObjectRow& object = tables_.objects[object_];
        if (position_ < object.count) {
            entry_ = EntryRef{&tables_.entries[object.first_entry + position_], object.index};
            ++position_;
            if (entry_.may(rights::stored)) {
                end_ += entry_.row->size;
                return true;
            }
        } else {
            position_ = 0U;
            ++object_;
        }
    }
    return false;
}

std::size_t size_of_stored(const DictionaryTables& tables) noexcept {
    StoredEntries stored{tables};
    while (stored.next()) {
        // to the last one
    }
    return stored.end();
}

/// Never written: as the memory was made, or as it was erased.
bool is_blank(const ByteView bytes) noexcept {
    bool same{true};
    for (std::size_t i = 1U; i < bytes.size(); ++i) {
        same = same && (std::uint32_t{bytes[i]} == bytes[0]);
    }
    return same && ((bytes[0] == 0xFFU) || (bytes[0] == 0x00U));
}

}  // namespace

ParameterStore::ParameterStore(ObjectDictionary& objects, NonVolatileMemory& memory,
                               const StoredNodeId stored_node_id) noexcept
    : objects_{objects},
      memory_{memory},
      stored_node_id_{stored_node_id},
      payload_size_{size_of_stored(objects.tables())} {}

bool ParameterStore::is_ours(const Header& header) const noexcept {
    return (number_at<magic_at>(header) == bank_magic) && (number_at<layout_at>(header) == objects_.tables().layout);
}

/// The CRC behind a bank is that of its bytes.
bool ParameterStore::is_intact(const std::size_t bank) const noexcept {
    Crc32 crc{};
    std::array<std::uint8_t, piece_size> bytes{};
    for (std::size_t at = 0U; at < bank_size(); at += piece_size) {
        const MutableBytes piece = MutableBytes{bytes}.part(0U, bank_size() - at);
        if (!memory_.read(bank_address(bank) + at, piece)) {
            return false;
        }
        crc.add(piece.view());
    }
    return crc.value() == Crc32::residue;
}

void ParameterStore::use(const std::size_t bank, const Header& header) noexcept {
    bank_ = bank;
    sequence_ = number_at<sequence_at>(header);
    groups_ = header[groups_at];
    saved_node_id_ = header[node_id_at];
    in_use_ = true;
}

StoredSet ParameterStore::open() noexcept {
    in_use_ = false;
    groups_ = no_groups;
    sequence_ = 0U;
    bool anything_written{false};
    for (std::size_t bank = 0U; bank < bank_count; ++bank) {
        Header header{};
        const bool readable = memory_.read(bank_address(bank), MutableBytes{header});
        anything_written = anything_written || !readable || !is_blank(ByteView{header});
        const bool newer = !in_use_ || is_newer(number_at<sequence_at>(header), sequence_);
        if (readable && newer && is_ours(header) && is_intact(bank)) {
            use(bank, header);
        }
    }
    if (in_use_) {
        return StoredSet::valid;
    }
    return anything_written ? StoredSet::corrupt : StoredSet::empty;
}

/// Moves a stored value from the node-ID with which it was saved to the one in use.
void ParameterStore::follow_node_id(const EntryRow& row, MutableBytes& value) const noexcept {
    if ((stored_node_id_ == StoredNodeId::holds) || !row.may(rights::node_id)) {
        return;
    }
    const std::uint64_t base = objects_.default_bits(row);
    if (read_le(value.view(), 0U, row.size) == (base + saved_node_id_)) {
        value.set_le(0U, row.size, base + node_id_);
    }
}

void ParameterStore::load(const ParameterGroups groups, const std::uint8_t node_id) noexcept {
    node_id_ = node_id;
    const ParameterGroups wanted = groups & groups_;
    StoredEntries stored{objects_.tables()};
    std::array<std::uint8_t, longest_value> bytes{};
    while (stored.next()) {
        const EntryRef& entry = stored.entry();
        MutableBytes value = MutableBytes{bytes}.part(0U, entry.row->size);
        if (((stored.group() & wanted) != 0U) && memory_.read(payload() + stored.offset(), value)) {
            follow_node_id(*entry.row, value);
            static_cast<void>(objects_.put(entry, value.view()));
        }
    }
}

static_assert(implements<req::CO_STORE_001> && implements<req::CO_STORE_002> && implements<req::CO_STORE_003> &&
              implements<req::CO_K_STORE_SIGNATURE> && implements<req::CO_K_RESTORE_SIGNATURE>);
AbortCode ParameterStore::execute(const EntryRef& entry, const std::uint32_t value) noexcept {
    const bool is_store = entry.index == store_index;
    if (value != (is_store ? store_signature : restore_signature)) {
        return AbortCode::cannot_store;
    }
    const ParameterGroups groups = groups_of(entry.row->subindex, !objects_.has(entry.index, 4U));
    ParameterGroups kept = groups_ & ~groups;
    if (is_store && ((groups & group_bit(ParameterGroup::manufacturer)) != 0U)) {
        kept = (kept & all_groups) | (ParameterGroups{mark_} << mark_shift);
    }
    return write_set(is_store ? groups : no_groups, kept);
}

void ParameterStore::Writer::write(const ByteView bytes) noexcept {
    crc_.add(bytes);
    if (done_) {
        done_ = memory_.write(at_, bytes);
    }
    at_ += bytes.size();
}

/// Copies a value from the bank in use.
void ParameterStore::keep_value(const EntryRow& row, const std::size_t from, Writer& to) const noexcept {
    std::array<std::uint8_t, piece_size> bytes{};
    for (std::size_t at = 0U; at < row.size; at += piece_size) {
        MutableBytes piece = MutableBytes{bytes}.part(0U, row.size - at);
        if (!memory_.read(from + at, piece)) {
            to.fail();
        }
        follow_node_id(row, piece);
        to.write(piece.view());
    }
}

void ParameterStore::write_values(const ParameterGroups fresh, Writer& to) const noexcept {
    StoredEntries stored{objects_.tables()};
    while (stored.next()) {
        const EntryRef& entry = stored.entry();
        if (((stored.group() & fresh) != 0U) || !in_use_) {
            to.write(objects_.bytes(*entry.row));
        } else {
            keep_value(*entry.row, payload() + stored.offset(), to);
        }
    }
}

static_assert(implements<req::CO_STORE_004> && implements<req::CO_STORE_005> && implements<req::CO_STORE_010>);
AbortCode ParameterStore::write_set(const ParameterGroups fresh, const ParameterGroups kept) noexcept {
    if (memory_.size() < needed_size()) {
        return AbortCode::hardware_error;
    }
    const std::size_t to_bank = in_use_ ? (1U - bank_) : 0U;
    Header header{};
    set_field_le<magic_at, 4U>(header, bank_magic);
    set_field_le<layout_at, 4U>(header, objects_.tables().layout);
    set_field_le<sequence_at, 4U>(header, sequence_ + 1U);
    header[groups_at] = static_cast<std::uint8_t>(fresh | kept);
    header[node_id_at] = node_id_;

    Writer to{memory_, bank_address(to_bank)};
    to.write(ByteView{header});
    write_values(fresh, to);
    std::array<std::uint8_t, crc_size> crc{};
    set_field_le<0U, crc_size>(crc, to.crc());
    to.write(ByteView{crc});
    if (!to.done() || !is_intact(to_bank)) {
        return AbortCode::hardware_error;
    }
    if (!memory_.commit()) {
        return AbortCode::hardware_error;
    }
    use(to_bank, header);
    return AbortCode::none;
}

}  // namespace canproof
