#include "firmware/canopen/object_dictionary.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

/// The number that `size` little-endian bytes stand for in a type of at most 32 bits.
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

std::size_t text_length(const ByteView text) noexcept {
    std::size_t length{0U};
    while ((length < text.size()) && (text[length] != 0U)) {
        ++length;
    }
    return length;
}

}  // namespace

bool has_variable_length(const DataType type) noexcept {
    return (type == DataType::visible_string) || (type == DataType::octet_string) || (type == DataType::domain);
}

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

const ObjectRow* ObjectDictionary::find_object(const std::uint16_t index) const noexcept {
    // The compiler leaves slots free, so that every search ends after a few steps.
    const std::size_t count = tables_.slots.count;
    std::size_t slot = object_slot(index, tables_.slot_factor, count);
    while (tables_.slots[slot] != no_object) {
        const ObjectRow& object = tables_.objects[tables_.slots[slot]];
        if (std::uint32_t{object.index} == index) {
            return &object;
        }
        slot = (slot + 1U) & (count - 1U);
    }
    return nullptr;
}

static_assert(implements<req::CO_SDO_008>);
Result<EntryRef, AbortCode> ObjectDictionary::find(const std::uint16_t index,
                                                   const std::uint8_t subindex) const noexcept {
    using Found = Result<EntryRef, AbortCode>;
    const ObjectRow* const object = find_object(index);
    if (object == nullptr) {
        return Found::failure(AbortCode::object_missing);
    }
    // Sub-indices ascend and rarely have holes: the wanted row lies at or before its own number.
    const std::size_t wanted{subindex};
    std::size_t at = (wanted < object->count) ? wanted : (object->count - std::size_t{1U});
    while ((at > 0U) && (tables_.entries[object->first_entry + at].subindex > wanted)) {
        --at;
    }
    const EntryRow& row = tables_.entries[object->first_entry + at];
    return (row.subindex == wanted) ? Found::success(EntryRef{&row, index})
                                    : Found::failure(AbortCode::subindex_missing);
}

ByteView ObjectDictionary::value(const EntryRef& entry) const noexcept {
    const EntryRow& row = *entry.row;
    const ByteView source =
        entry.may(rights::constant) ? ByteView{tables_.constants.rows, tables_.constants.count} : image_.view();
    const ByteView bytes = source.part(row.offset, row.size);
    return (row.type == DataType::visible_string) ? bytes.part(0U, text_length(bytes)) : bytes;
}

AbortCode ObjectDictionary::check_write(const EntryRef& entry, const ByteView value) const noexcept {
    const EntryRow& row = *entry.row;
    if (!entry.may(rights::write)) {
        return AbortCode::read_only;
    }
    if (value.size() > row.size) {
        return AbortCode::too_long;
    }
    if (!has_variable_length(row.type) && (value.size() < row.size)) {
        return AbortCode::too_short;
    }
    return check_value(entry, value);
}

AbortCode ObjectDictionary::check_value(const EntryRef& entry, const ByteView value) const noexcept {
    if (has_variable_length(entry.row->type)) {
        return AbortCode::none;
    }
    const std::uint64_t bits = read_le(value, 0U, value.size());
    if ((entry.row->type == DataType::boolean) && (bits > 1U)) {
        return AbortCode::value_range;
    }
    return (entry.row->limit == no_limit) ? AbortCode::none : check_limits(entry, bits);
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

std::int64_t ObjectDictionary::integer_limit(const Limit& limit, const EntryRef& entry) const noexcept {
    if (limit.kind != LimitKind::entry) {
        return as_integer(entry.row->type, limit.bits);
    }
    const std::uint32_t wanted_subindex = limit.bits & 0xFFU;
    const std::uint8_t subindex =
        (wanted_subindex == same_subindex) ? entry.row->subindex : static_cast<std::uint8_t>(wanted_subindex);
    const std::uint32_t bits = read(static_cast<std::uint16_t>(limit.bits >> 8U), subindex);
    return as_integer(entry.row->type, bits) + limit.add;
}

AbortCode ObjectDictionary::check_limits(const EntryRef& entry, const std::uint64_t bits) const noexcept {
    const LimitRow& limits = tables_.limits[entry.row->limit];
    if (limits.minimum.kind == LimitKind::list) {
        return in_list(limits.minimum, static_cast<std::uint32_t>(bits)) ? AbortCode::none : AbortCode::value_range;
    }
    bool below{false};
    bool above{false};
    if (entry.row->type == DataType::real32) {
        const float value = as_real(bits);
        if (!std::isfinite(value)) {
            return AbortCode::value_range;
        }
        below = (limits.minimum.kind == LimitKind::value) && (value < as_real(limits.minimum.bits));
        above = (limits.maximum.kind == LimitKind::value) && (value > as_real(limits.maximum.bits));
    } else {
        const std::int64_t value = as_integer(entry.row->type, bits);
        if ((limits.minimum.kind == LimitKind::value_or_zero) && (value == 0)) {
            return AbortCode::none;
        }
        below = (limits.minimum.kind != LimitKind::none) && (value < integer_limit(limits.minimum, entry));
        above = (limits.maximum.kind != LimitKind::none) && (value > integer_limit(limits.maximum, entry));
    }
    if (!below && !above) {
        return AbortCode::none;
    }
    if (limit_abort_ == LimitAbort::range) {
        return AbortCode::value_range;
    }
    return above ? AbortCode::value_too_high : AbortCode::value_too_low;
}

void ObjectDictionary::put(const EntryRef& entry, const ByteView value) noexcept {
    const EntryRow& row = *entry.row;
    if (entry.may(rights::constant)) {
        return;
    }
    const MutableBytes place = image_.part(row.offset, row.size);
    for (std::size_t i = 0U; i < row.size; ++i) {
        MutableBytes{place}.set(i, value[i]);
    }
}

void ObjectDictionary::load_defaults(const ParameterGroup group, const std::uint8_t node_id) noexcept {
    const ByteView defaults{tables_.defaults.rows, tables_.defaults.count};
    for (const ObjectRow& object : tables_.objects) {
        if (parameter_group(object.index) != group) {
            continue;
        }
        for (std::size_t i = 0U; i < object.count; ++i) {
            const EntryRef entry{&tables_.entries[object.first_entry + i], object.index};
            if (entry.may(rights::constant)) {
                continue;
            }
            put(entry, defaults.part(entry.row->offset, entry.row->size));
            if (entry.may(rights::node_id)) {
                const std::uint64_t base = read_le(value(entry), 0U, entry.row->size);
                write_le(image_, entry.row->offset, entry.row->size, base + node_id);
            }
        }
    }
}

std::uint32_t ObjectDictionary::read(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
    const auto found = find(index, subindex);
    if (!found.ok()) {
        return 0U;
    }
    const ByteView bytes = value(found.value());
    return static_cast<std::uint32_t>(read_le(bytes, 0U, (bytes.size() < 4U) ? bytes.size() : 4U));
}

void ObjectDictionary::write(const std::uint16_t index, const std::uint8_t subindex,
                             const std::uint32_t bits) noexcept {
    const auto found = find(index, subindex);
    if (found.ok()) {
        const EntryRow& row = *found.value().row;
        write_le(image_, row.offset, row.size, bits);
    }
}

}  // namespace canproof
