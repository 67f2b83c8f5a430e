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
constexpr std::size_t chunk_size = 64U;            // longest stored value, and the piece in which a bank is checked

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

/// Calls `visit(entry, group bit, offset in the payload)` for each stored entry, in dictionary order.
template <typename Visit>
void for_each_stored(const DictionaryTables& tables, const Visit& visit) noexcept {
    std::size_t offset{0U};
    for (const ObjectRow& object : tables.objects) {
        const ParameterGroups group = group_bit(parameter_group(object.index));
        for (std::size_t i = 0U; i < object.count; ++i) {
            const EntryRef entry{&tables.entries[object.first_entry + i], object.index};
            if (entry.may(rights::stored)) {
                visit(entry, group, offset);
                offset += entry.row->size;
            }
        }
    }
}

/// Bytes of all stored values.
std::size_t payload_size_of(const DictionaryTables& tables) noexcept {
    std::size_t size{0U};
    for_each_stored(tables, [&size](const EntryRef& entry, ParameterGroups, std::size_t) { size += entry.row->size; });
    return size;
}

}  // namespace

ParameterStore::ParameterStore(ObjectDictionary& objects, NonVolatileMemory& memory,
                               const StoredNodeId stored_node_id) noexcept
    : objects_{objects},
      memory_{memory},
      payload_size_{payload_size_of(objects.tables())},
      stored_node_id_{stored_node_id} {}

ParameterStore::Header ParameterStore::read_header(const std::size_t bank) const noexcept {
    std::array<std::uint8_t, header_size> bytes{};
    Header header{};
    if (memory_.read(bank_address(bank), MutableBytes{bytes})) {
        header.magic = read_u32(ByteView{bytes}, 0U);
        header.layout = read_u32(ByteView{bytes}, 4U);
        header.sequence = read_u32(ByteView{bytes}, 8U);
        header.groups = bytes[12];
        header.node_id = bytes[13];
    }
    return header;
}

bool ParameterStore::is_blank(const std::size_t bank) const noexcept {
    std::array<std::uint8_t, header_size> bytes{};
    if (!memory_.read(bank_address(bank), MutableBytes{bytes})) {
        return false;
    }
    bool all_ones{true};
    bool all_zeros{true};
    for (const std::uint8_t byte : bytes) {
        all_ones = all_ones && (byte == 0xFFU);
        all_zeros = all_zeros && (byte == 0x00U);
    }
    return all_ones || all_zeros;
}

bool ParameterStore::is_sound(const std::size_t bank, const Header& header) const noexcept {
    if ((header.magic != bank_magic) || (header.layout != objects_.tables().layout)) {
        return false;
    }
    const std::size_t checked = header_size + payload_size_;
    Crc32 crc{};
    std::array<std::uint8_t, chunk_size> chunk{};
    for (std::size_t at = 0U; at < checked; at += chunk_size) {
        const std::size_t length = ((checked - at) < chunk_size) ? (checked - at) : chunk_size;
        const MutableBytes part{chunk.data(), length};
        if (!memory_.read(bank_address(bank) + at, part)) {
            return false;
        }
        crc.add(part.view());
    }
    std::array<std::uint8_t, crc_size> stored{};
    return memory_.read(bank_address(bank) + checked, MutableBytes{stored}) &&
           (read_u32(ByteView{stored}, 0U) == crc.value());
}

StoredSet ParameterStore::open() noexcept {
    in_use_ = false;
    current_ = Header{};
    bool anything_written{false};
    for (std::size_t bank = 0U; bank < bank_count; ++bank) {
        const Header header = read_header(bank);
        anything_written = anything_written || !is_blank(bank);
        const bool newer = !in_use_ || is_newer(header.sequence, current_.sequence);
        if (newer && is_sound(bank, header)) {
            in_use_ = true;
            bank_ = bank;
            current_ = header;
        }
    }
    if (in_use_) {
        return StoredSet::valid;
    }
    return anything_written ? StoredSet::corrupt : StoredSet::empty;
}

/// Moves a stored value from the node-ID with which it was saved to the one in use.
void ParameterStore::follow_node_id(const EntryRef& entry, MutableBytes value) const noexcept {
    const EntryRow& row = *entry.row;
    if ((stored_node_id_ == StoredNodeId::holds) || !entry.may(rights::node_id)) {
        return;
    }
    const ByteView defaults{objects_.tables().defaults.rows, objects_.tables().defaults.count};
    const std::uint64_t base = read_le(defaults, row.offset, row.size);
    if (read_le(value.view(), 0U, row.size) == (base + current_.node_id)) {
        write_le(value, 0U, row.size, base + node_id_);
    }
}

void ParameterStore::load(const ParameterGroups groups, const std::uint8_t node_id) noexcept {
    node_id_ = node_id;
    const ParameterGroups wanted = groups & current_.groups;
    const std::size_t payload = bank_address(bank_) + header_size;
    std::array<std::uint8_t, chunk_size> bytes{};
    for_each_stored(objects_.tables(), [this, wanted, payload, &bytes](
                                           const EntryRef& entry, const ParameterGroups group, const std::size_t at) {
        const MutableBytes value = MutableBytes{bytes}.part(0U, entry.row->size);
        if (((group & wanted) != 0U) && memory_.read(payload + at, value)) {
            follow_node_id(entry, value);
            static_cast<void>(objects_.put(entry, value.view()));
        }
    });
}

static_assert(implements<req::CO_STORE_001> && implements<req::CO_STORE_002> && implements<req::CO_STORE_003> &&
              implements<req::CO_K_STORE_SIGNATURE> && implements<req::CO_K_RESTORE_SIGNATURE>);
AbortCode ParameterStore::execute(const EntryRef& entry, const ByteView value) noexcept {
    const bool is_store = entry.index == store_index;
    if (read_u32(value, 0U) != (is_store ? store_signature : restore_signature)) {
        return AbortCode::cannot_store;
    }
    const ParameterGroups groups = groups_of(entry.row->subindex, !objects_.has(entry.index, 4U));
    const ParameterGroups others = current_.groups & ~groups;
    return is_store ? write_set(groups, others) : write_set(no_groups, others);
}

bool ParameterStore::write_checked(const std::size_t at, const ByteView bytes, Crc32& crc) noexcept {
    crc.add(bytes);
    return memory_.write(at, bytes);
}

bool ParameterStore::copy_values(const std::size_t to_bank, const ParameterGroups fresh, Crc32& crc) noexcept {
    const std::size_t source = bank_address(bank_) + header_size;
    const std::size_t target = bank_address(to_bank) + header_size;
    bool done{true};
    std::array<std::uint8_t, chunk_size> bytes{};
    for_each_stored(objects_.tables(), [this, fresh, source, target, &crc, &done, &bytes](
                                           const EntryRef& entry, const ParameterGroups group, const std::size_t at) {
        const MutableBytes value = MutableBytes{bytes}.part(0U, entry.row->size);
        if (((group & fresh) != 0U) || !in_use_) {
            MutableBytes{value}.copy(0U, objects_.image().view().part(entry.row->offset, entry.row->size));
        } else {
            done = done && memory_.read(source + at, value);
            follow_node_id(entry, value);
        }
        if (done) {
            done = write_checked(target + at, value.view(), crc);
        }
    });
    return done;
}

static_assert(implements<req::CO_STORE_004> && implements<req::CO_STORE_005>);
AbortCode ParameterStore::write_set(const ParameterGroups fresh, const ParameterGroups kept) noexcept {
    if (memory_.size() < needed_size()) {
        return AbortCode::hardware_error;
    }
    const std::size_t to_bank = in_use_ ? (1U - bank_) : 0U;
    Header header{};
    header.magic = bank_magic;
    header.layout = objects_.tables().layout;
    header.sequence = current_.sequence + 1U;
    header.groups = fresh | kept;
    header.node_id = node_id_;

    std::array<std::uint8_t, header_size> bytes{};
    write_le(MutableBytes{bytes}, 0U, 4U, header.magic);
    write_le(MutableBytes{bytes}, 4U, 4U, header.layout);
    write_le(MutableBytes{bytes}, 8U, 4U, header.sequence);
    bytes[12] = static_cast<std::uint8_t>(header.groups);
    bytes[13] = header.node_id;

    Crc32 crc{};
    bool done = write_checked(bank_address(to_bank), ByteView{bytes}, crc);
    if (done) {
        done = copy_values(to_bank, fresh, crc);
    }
    if (done) {
        std::array<std::uint8_t, crc_size> check{};
        write_le(MutableBytes{check}, 0U, crc_size, crc.value());
        done = memory_.write(bank_address(to_bank) + header_size + payload_size_, ByteView{check});
    }
    done = done && is_sound(to_bank, header);
    if (!done) {
        return AbortCode::hardware_error;
    }
    bank_ = to_bank;
    current_ = header;
    in_use_ = true;
    return AbortCode::none;
}

}  // namespace canproof
