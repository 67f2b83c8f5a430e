// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/parameter_store.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/sequence_number.hpp"
#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

using generated::canopen::restore_signature;
using generated::canopen::store_signature;

constexpr std::uint32_t bank_magic = 0x53504F43U;  // "COPS" in memory; its last letter is the commit marker
constexpr std::uint8_t committed_marker = 0x53U;
constexpr std::size_t longest_value = 64U;  // greatest length of a stored value, in bytes
constexpr std::size_t piece_size = 16U;     // in bytes: a bank is checked and copied in pieces of this size
// Fields of a bank's header.
constexpr std::size_t magic_at = 0U;
constexpr std::size_t layout_at = 4U;
constexpr std::size_t sequence_at = 8U;
constexpr std::size_t groups_at = 12U;
constexpr std::size_t node_ids_at = 13U;  // one node-ID for each group

template <std::size_t at, std::size_t size>
std::uint32_t number_at(const std::array<std::uint8_t, size>& bytes) noexcept {
    return static_cast<std::uint32_t>(field_le<at, sizeof(std::uint32_t)>(bytes));
}

/// Steps through the stored entries in dictionary order.
class StoredEntries {
  public:
    explicit StoredEntries(const DictionaryTables& tables) noexcept : tables_{tables} {}

    /// Goes to the next stored entry; the first call goes to the first one. Returns false after the last entry.
    bool next() noexcept;
    const EntryRef& entry() const noexcept { return entry_; }
    ParameterGroups group() const noexcept { return group_bit(parameter_group(entry_.index)); }
    /// Returns the position of the entry's value in the payload, in bytes.
    std::size_t offset() const noexcept { return end_ - entry_.row->size; }
    /// Returns the number of payload bytes up to the end of this value.
    std::size_t end() const noexcept { return end_; }

  private:
    const DictionaryTables& tables_;
    std::size_t object_{0U};
    std::size_t position_{0U};  ///< position among the entries of the object
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
        // next() moves to the following entry; the loop ends behind the last one
    }
    return stored.end();
}

}  // namespace

ParameterStore::ParameterStore(ObjectDictionary& objects, NonVolatileMemory& memory) noexcept
    : objects_{objects}, memory_{memory}, payload_size_{size_of_stored(objects.tables())} {}

static_assert(implements<req::CO_STORE_019>);
bool ParameterStore::is_ours(const Header& header) const noexcept {
    return (number_at<magic_at>(header) == bank_magic) && (number_at<layout_at>(header) == objects_.tables().layout);
}

/// Returns whether the CRC of a bank is right. The CRC was computed with the committed marker, so the present marker
/// does not matter.
bool ParameterStore::is_intact(const std::size_t bank) const noexcept {
    Crc32 crc{};
    std::array<std::uint8_t, piece_size> bytes{};
    for (std::size_t at = 0U; at < bank_size(); at += piece_size) {
        MutableBytes piece = MutableBytes{bytes}.part(0U, bank_size() - at);
        if (!memory_.read(bank_address(bank) + at, piece)) {
            return false;
        }
        if (at == 0U) {
            piece.set(commit_marker_at, committed_marker);
        }
        crc.add(piece.view());
    }
    return crc.value() == Crc32::residue;
}

void ParameterStore::use(const std::size_t bank, const Header& header) noexcept {
    bank_ = bank;
    sequence_ = number_at<sequence_at>(header);
    groups_ = header[groups_at];
    for (std::size_t group = 0U; group < parameter_group_count; ++group) {
        saved_node_ids_[group] = header[node_ids_at + group];
    }
    in_use_ = true;
}

BankState ParameterStore::inspect(const std::size_t bank, Header& header) const noexcept {
    const bool is_readable = memory_.read(bank_address(bank), MutableBytes{header});
    const BankState state = state_by_marker(is_readable, ByteView{header}, committed_marker);
    header[commit_marker_at] = committed_marker;
    const bool is_sound = (state != BankState::unused) && is_readable && is_ours(header) && is_intact(bank);
    return is_sound ? BankState::sound : state;
}

static_assert(implements<req::CO_STORE_006> && implements<req::CO_STORE_017>);
void ParameterStore::open() noexcept {
    BankState held{BankState::unused};
    for (std::size_t bank = 0U; bank < bank_count; ++bank) {
        Header header{};
        const BankState found = inspect(bank, header);
        const bool is_newer_set = (found == BankState::sound) && is_newer(number_at<sequence_at>(header), sequence_);
        if ((found > held) || ((found == held) && is_newer_set)) {
            held = found;
            use(bank, header);
        }
    }
    damaged_ = (held == BankState::doubtful) || (held == BankState::damaged);
    if (held != BankState::sound) {
        give_up();
    }
}

/// Stops the use of all stored values: the next load() keeps the defaults.
void ParameterStore::give_up() noexcept {
    in_use_ = false;
    groups_ = no_groups;
}

/// Adapts a loaded COB-ID to the present node-ID if its identifier was the default for the node-ID at the save. Bits 30
/// and 31 are flags and stay as they are; a client that changed only these flags has not chosen another identifier.
static_assert(implements<req::CO_PDO_035> && implements<req::CO_PDO_060> && implements<req::CO_PDO_061>);
void ParameterStore::follow_node_id(const EntryRow& row, const std::uint8_t saved_node_id) noexcept {
    const std::uint64_t loaded = objects_.bits(row);
    const std::uint64_t shipped = objects_.default_bits(row) + saved_node_id;
    if (((loaded ^ shipped) & cob_id::identifier_mask) == 0U) {
        static_cast<void>(objects_.put_bits(row, (loaded - saved_node_id) + node_id_));
    }
}

void ParameterStore::load(const ParameterGroup group, const std::uint8_t node_id) noexcept {
    node_id_ = node_id;
    const ParameterGroups wanted = group_bit(group) & groups_;
    const std::uint8_t saved_node_id = saved_node_ids_[static_cast<std::size_t>(group)];
    StoredEntries stored{objects_.tables()};
    std::array<std::uint8_t, longest_value> bytes{};
    while (stored.next()) {
        if ((stored.group() & wanted) == 0U) {
            continue;
        }
        const EntryRef& entry = stored.entry();
        const EntryRow& row = *entry.row;
        const MutableBytes value = MutableBytes{bytes}.part(0U, row.size);
        if (!memory_.read(payload() + stored.offset(), value)) {
            damaged_ = true;
            give_up();
            return;
        }
        static_cast<void>(objects_.put(entry, value.view()));
        if (row.may(rights::node_id)) {
            follow_node_id(row, saved_node_id);
        }
    }
}

/// CiA 301 assigns application parameters to sub-index 3 and manufacturer parameters to 4 and above (7.5.2.13). A
/// device whose list ends at 3 has manufacturer parameters there and no application parameters (AX060805, 4.2.7).
ParameterGroups ParameterStore::groups_of(const EntryRef& entry) const noexcept {
    const bool ends_at_3 = !objects_.has(entry.index, 4U);
    switch (entry.row->subindex) {
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

static_assert(implements<req::CO_STORE_001> && implements<req::CO_STORE_003> && implements<req::CO_STORE_012>);
AbortCode ParameterStore::execute(const EntryRef& entry, const std::uint32_t value) noexcept {
    const bool is_store = entry.index == index::store_parameters;
    static_assert(implements<req::CO_STORE_002> && implements<req::CO_K_STORE_SIGNATURE> &&
                  implements<req::CO_K_RESTORE_SIGNATURE>);
    if (value != (is_store ? store_signature : restore_signature)) {
        return AbortCode::cannot_store;
    }
    const ParameterGroups groups = groups_of(entry);
    ParameterGroups kept = groups_ & ~groups;
    if (is_store && has_group(groups, ParameterGroup::manufacturer)) {
        kept = (kept & all_groups) | (ParameterGroups{tag_} << tag_shift);
    }
    return write_set(is_store ? groups : no_groups, kept);
}

void ParameterStore::Writer::write_header(Header header) noexcept {
    crc_.add(ByteView{header});
    header[commit_marker_at] = void_marker;
    put(ByteView{header});
}

void ParameterStore::Writer::put(const ByteView bytes) noexcept {
    if (done_) {
        done_ = memory_.write(at_, bytes);
    }
    at_ += bytes.size();
}

/// Copies a value from the bank in use to the bank that is being written.
static_assert(implements<req::CO_STORE_011>);
void ParameterStore::keep_value(const EntryRow& row, const std::size_t from, Writer& to) const noexcept {
    std::array<std::uint8_t, piece_size> bytes{};
    for (std::size_t at = 0U; at < row.size; at += piece_size) {
        MutableBytes piece = MutableBytes{bytes}.part(0U, row.size - at);
        if (!memory_.read(from + at, piece)) {
            to.fail();
        }
        to.write(piece.view());
    }
}

void ParameterStore::write_values(const ParameterGroups fresh, Writer& to) const noexcept {
    StoredEntries stored{objects_.tables()};
    while (stored.next()) {
        const EntryRef& entry = stored.entry();
        if (((stored.group() & fresh) != 0U) || !in_use_) {
            static_assert(implements<req::CO_VERIFY_004>);
            to.write(objects_.bytes(*entry.row));
        } else {
            keep_value(*entry.row, payload() + stored.offset(), to);
        }
    }
}

bool ParameterStore::write_marker(const std::size_t bank, const std::uint8_t marker) noexcept {
    return memory_.write(bank_address(bank) + commit_marker_at, ByteView{&marker, 1U});
}

/// Makes the new set in bank `to_bank` the valid one. After a failure, the set stored before is the valid one.
static_assert(implements<req::CO_STORE_013>);
bool ParameterStore::commit_bank(const std::size_t to_bank) noexcept {
    bool done = write_marker(to_bank, committed_marker);
    if (done) {
        // If this write fails, two sound banks remain; the sequence number still shows which one is newer. But a
        // damaged bank has priority over the new one.
        done = write_marker(bank_, void_marker) || !damaged_;
    }
    if (!done) {
        // The committed marker may be in the memory, although its write failed.
        static_cast<void>(write_marker(to_bank, void_marker));
        return false;
    }
    static_assert(implements<req::CO_STORE_014> && implements<req::CO_STORE_018>);
    return memory_.commit();
}

static_assert(implements<req::CO_STORE_004> && implements<req::CO_STORE_005> && implements<req::CO_STORE_010>);
AbortCode ParameterStore::write_set(const ParameterGroups fresh, const ParameterGroups kept) noexcept {
    if (memory_.size() < needed_size()) {
        return AbortCode::hardware_error;
    }
    static_assert(implements<req::CO_STORE_013>);
    const std::size_t to_bank = 1U - bank_;
    if (!write_marker(to_bank, void_marker)) {
        return AbortCode::hardware_error;
    }
    Header header{};
    set_field_le<magic_at, 4U>(header, bank_magic);
    set_field_le<layout_at, 4U>(header, objects_.tables().layout);
    set_field_le<sequence_at, 4U>(header, sequence_ + 1U);
    header[groups_at] = static_cast<std::uint8_t>(fresh | kept);
    for (std::size_t group = 0U; group < parameter_group_count; ++group) {
        const bool is_fresh = (((fresh >> group) & 1U) != 0U) || !in_use_;
        header[node_ids_at + group] = is_fresh ? node_id_ : saved_node_ids_[group];
    }

    Writer to{memory_, bank_address(to_bank)};
    to.write_header(header);
    write_values(fresh, to);
    std::array<std::uint8_t, crc_size> crc{};
    set_field_le<0U, crc_size>(crc, to.crc());
    to.write(ByteView{crc});
    if (!to.done() || !is_intact(to_bank)) {
        return AbortCode::hardware_error;
    }
    if (!commit_bank(to_bank)) {
        return AbortCode::hardware_error;
    }
    use(to_bank, header);
    return AbortCode::none;
}

}  // namespace canproof
