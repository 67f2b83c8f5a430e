// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/object_dictionary.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

/// Converts the bits of an integer type of at most 32 bits to a number.
std::int64_t as_integer(const DataType type, const std::uint64_t bits) noexcept {
    switch (type) {
        case DataType::integer8:
            return static_cast<std::int8_t>(static_cast<std::uint8_t>(bits));
        case DataType::integer16:
            return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
        case DataType::integer32:
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
        default:
            return static_cast<std::int64_t>(bits);
    }
}

float as_real(const std::uint64_t bits) noexcept {
    return bit_cast<float>(static_cast<std::uint32_t>(bits));
}

/// A word of this processor: eight bytes or four.
using Word = std::size_t;

/// Returns whether one of the bytes of `word` is zero. Subtracting 1 from a byte below 80h sets its highest bit only if
/// the byte is zero. No byte borrows from the next one before the lowest zero byte does, so the result is right for
/// this byte, and without a zero byte there is no borrow.
constexpr bool has_zero_byte(const Word word) noexcept {
    constexpr Word lowest_bits = SIZE_MAX / 0xFFU;  // 01h in each byte
    constexpr Word highest_bits = lowest_bits << 7U;
    return ((word - lowest_bits) & ~word & highest_bits) != 0U;
}

/// Searches the row of a sub-index. The sub-indices of an object ascend from 0. If no lower sub-index is absent, the
/// row is number `subindex` of the object's rows, counted from 0. Otherwise it is an earlier one.
EntryRef search(const DictionaryTables& tables, const ObjectRow& object, const std::uint8_t subindex) noexcept {
    const std::size_t first = object.first_entry;
    const std::size_t wanted = subindex;
    std::size_t place = first + ((wanted < object.count) ? wanted : (object.count - std::size_t{1U}));
    while ((place != first) && (std::uint32_t{tables.entries[place].subindex} > subindex)) {
        --place;
    }
    const EntryRow& row = tables.entries[place];
    return EntryRef{(std::uint32_t{row.subindex} == subindex) ? &row : nullptr, object.index};
}

}  // namespace

ParameterGroup parameter_group(const std::uint16_t index) noexcept {
    constexpr std::uint32_t first_manufacturer_index{0x2000U};
    constexpr std::uint32_t first_profile_index{0x6000U};
    if (index < first_manufacturer_index) {
        return ParameterGroup::communication;
    }
    return (index < first_profile_index) ? ParameterGroup::manufacturer : ParameterGroup::application;
}

ObjectDictionary::ObjectDictionary(const DictionaryTables& tables, const MutableBytes image,
                                   const LimitAbort limit_abort) noexcept
    : tables_{tables}, image_{image}, limit_abort_{limit_abort} {}

EntryRef ObjectDictionary::lookup(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
    const ObjectRow* const object = object_row(index);
    if (object == nullptr) {
        return EntryRef{nullptr, index};
    }
    const EntryRow* const row = near_row(*object, subindex);
    return (row != nullptr) ? EntryRef{row, index} : search(tables_, *object, subindex);
}

static_assert(implements<req::CO_SDO_057>);
AbortCode ObjectDictionary::missing(const std::uint16_t index) const noexcept {
    return has(index, 0U) ? AbortCode::subindex_missing : AbortCode::object_missing;
}

static_assert(implements<req::CO_SDO_008>);
Result<EntryRef, AbortCode> ObjectDictionary::find(const std::uint16_t index,
                                                   const std::uint8_t subindex) const noexcept {
    using Found = Result<EntryRef, AbortCode>;
    const EntryRef entry = lookup(index, subindex);
    return entry.exists() ? Found::success(entry) : Found::failure(missing(index));
}

ByteView ObjectDictionary::text_of(const ByteView bytes) noexcept {
    constexpr std::size_t step = sizeof(Word);
    const std::size_t words = bytes.size() - (bytes.size() % step);
    std::size_t length{0U};
    while ((length < words) && !has_zero_byte(static_cast<Word>(load_le<step>(bytes, length)))) {
        length += step;
    }
    while ((length < bytes.size()) && (bytes[length] != 0U)) {
        ++length;
    }
    return bytes.part(0U, length);
}

static_assert(implements<req::CO_SDO_009> && implements<req::CO_SDO_010> && implements<req::CO_SDO_059>);
AbortCode ObjectDictionary::check_write(const EntryRef& entry, const ByteView value) const noexcept {
    const AbortCode code = check_length(*entry.row, value.size());
    return (code == AbortCode::none) ? check_value(entry, value) : code;
}

AbortCode ObjectDictionary::check_value(const EntryRef& entry, const ByteView value) const noexcept {
    const bool is_number = !has_variable_length(entry.row->type);
    return is_number ? check_bits(*entry.row, number_in(value)) : AbortCode::none;
}

bool ObjectDictionary::in_list(const Limit& list, const std::uint32_t bits) const noexcept {
    const std::size_t first = list.bits >> 16U;
    const std::size_t count = list.bits & 0xFFFFU;
    bool found{false};
    for (std::size_t i = 0U; i < count; ++i) {
        found = found || (tables_.allowed[first + i] == bits);
    }
    return found;
}

std::int64_t ObjectDictionary::integer_limit(const Limit& limit, const EntryRow& row) const noexcept {
    if (limit.kind != LimitKind::entry) {
        return as_integer(row.type, limit.bits);
    }
    const std::uint32_t wanted_subindex = limit.bits & 0xFFU;
    const std::uint8_t subindex =
        (wanted_subindex == same_subindex) ? row.subindex : static_cast<std::uint8_t>(wanted_subindex);
    const std::uint32_t bits = read(static_cast<std::uint16_t>(limit.bits >> 8U), subindex);
    return as_integer(row.type, bits) + limit.add;
}

static_assert(implements<req::CO_SDO_040> && implements<req::CO_SDO_062>);
static_assert(implements<req::CO_EMCY_027>);
AbortCode ObjectDictionary::check_limits(const EntryRow& row, const std::uint64_t bits) const noexcept {
    const LimitRow& limits = tables_.limits[row.limit];
    if (limits.minimum.kind == LimitKind::list) {
        return in_list(limits.minimum, static_cast<std::uint32_t>(bits)) ? AbortCode::none : AbortCode::value_range;
    }
    bool below{false};
    bool above{false};
    if (row.type == DataType::real32) {
        const float value = as_real(bits);
        if (!std::isfinite(value)) {
            return AbortCode::value_range;
        }
        below = (limits.minimum.kind == LimitKind::value) && (value < as_real(limits.minimum.bits));
        above = (limits.maximum.kind == LimitKind::value) && (value > as_real(limits.maximum.bits));
    } else {
        const std::int64_t value = as_integer(row.type, bits);
        if ((limits.minimum.kind == LimitKind::value_or_zero) && (value == 0)) {
            return AbortCode::none;
        }
        below = (limits.minimum.kind != LimitKind::none) && (value < integer_limit(limits.minimum, row));
        above = (limits.maximum.kind != LimitKind::none) && (value > integer_limit(limits.maximum, row));
    }
    if (!below && !above) {
        return AbortCode::none;
    }
    if (limit_abort_ == LimitAbort::range) {
        return AbortCode::value_range;
    }
    return above ? AbortCode::value_too_high : AbortCode::value_too_low;
}

bool ObjectDictionary::put(const EntryRef& entry, const ByteView value) noexcept {
    const EntryRow& row = *entry.row;
    if (entry.may(rights::constant)) {
        return false;
    }
    note_change_at(row.offset);
    MutableBytes place = image_.part(row.offset, row.size);
    bool changes{false};
    for (std::size_t i = 0U; i < row.size; ++i) {
        changes = changes || (std::uint32_t{place[i]} != value[i]);
        place.set(i, value[i]);
    }
    return changes;
}

bool ObjectDictionary::put_bits(const EntryRow& row, const std::uint64_t bits) noexcept {
    if (row.may(rights::constant)) {
        return false;
    }
    note_change_at(row.offset);
    return image_.exchange_le(row.offset, row.size, bits);
}

void ObjectDictionary::load_defaults(const ParameterGroup group, const std::uint8_t node_id) noexcept {
    const ByteView defaults{tables_.defaults.rows, tables_.defaults.count};
    for (const ObjectRow& object : tables_.objects) {
        if ((parameter_group(object.index) != group) || (std::uint32_t{object.index} == index::error_list)) {
            continue;
        }
        for (std::size_t i = 0U; i < object.count; ++i) {
            const EntryRef entry{&tables_.entries[object.first_entry + i], object.index};
            if (entry.may(rights::constant)) {
                continue;
            }
            static_cast<void>(put(entry, defaults.part(entry.row->offset, entry.row->size)));
            if (entry.may(rights::node_id)) {
                std::array<std::uint8_t, sizeof(std::uint64_t)> sum{};
                set_field_le<0U, sizeof(std::uint64_t)>(sum, bits(*entry.row) + node_id);
                static_cast<void>(put(entry, ByteView{sum}));
            }
        }
    }
}

std::uint64_t ObjectDictionary::bits(const EntryRow& row) const noexcept {
    return read_le(pool(row), row.offset, row.size);
}

std::uint64_t ObjectDictionary::default_bits(const EntryRow& row) const noexcept {
    return read_le(ByteView{tables_.defaults.rows, tables_.defaults.count}, row.offset, row.size);
}

std::uint32_t ObjectDictionary::read(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
    constexpr std::size_t longest = sizeof(std::uint32_t);
    const EntryRef entry = lookup(index, subindex);
    if (!entry.exists()) {
        return 0U;
    }
    const std::size_t size = entry.row->size;
    return static_cast<std::uint32_t>(read_le(pool(*entry.row), entry.row->offset, (size < longest) ? size : longest));
}

void ObjectDictionary::write(const std::uint16_t index, const std::uint8_t subindex,
                             const std::uint32_t bits) noexcept {
    const EntryRef entry = lookup(index, subindex);
    if (entry.exists()) {
        static_cast<void>(put_bits(*entry.row, bits));
    }
}

}  // namespace canproof
