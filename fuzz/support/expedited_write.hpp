// SPDX-License-Identifier: Apache-2.0
// Recognises the only SDO requests that the naive models of devices know: expedited downloads of a whole entry.
#pragma once

#include <optional>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::fuzz {

struct ExpeditedWrite {
    EntryRef entry;
    std::uint32_t bits;  ///< value in the request, of as many bytes as the entry has

    std::uint16_t index() const { return entry.index; }
    std::uint8_t sub() const { return entry.row->subindex; }
    std::uint32_t address() const { return (entry.index * 0x100U) + entry.row->subindex; }
    /// Returns the value as its type defines it: an integer with its sign, a REAL32, or a boolean as 0 or 1.
    double value() const {
        switch (entry.row->type) {
            case DataType::integer8:
                return static_cast<std::int8_t>(bits);
            case DataType::integer16:
                return static_cast<std::int16_t>(bits);
            case DataType::integer32:
                return static_cast<std::int32_t>(bits);
            case DataType::real32:
                return static_cast<double>(bit_cast<float>(bits));
            default:
                return bits;
        }
    }
};

/// Returns the write in a request of eight bytes. Returns nothing for any other request, for an entry that is absent or
/// read only, and for another length than that of the entry.
inline std::optional<ExpeditedWrite> expedited_write(const ObjectDictionary& objects, const Frame& request) {
    const std::uint8_t command = request.data[0];
    if (request.length != max_frame_length || (command & 0xF3U) != 0x23U) {
        return std::nullopt;
    }
    const std::size_t size = 4U - ((command >> 2U) & 3U);
    const EntryRef entry =
        objects.lookup(static_cast<std::uint16_t>(read_le(request.payload(), 1, 2)), request.data[3]);
    if (!entry.exists() || !entry.may(rights::write) || entry.row->size != size) {
        return std::nullopt;
    }
    return ExpeditedWrite{entry, static_cast<std::uint32_t>(read_le(request.payload(), 4, size))};
}

/// Returns the request of an expedited write. `size` is the length of the entry in bytes.
inline Frame write_request(unsigned node, unsigned index, unsigned sub, unsigned size, std::uint32_t bits) {
    Frame request = data_frame(0x600U + node, max_frame_length);
    request.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
    write_le(MutableBytes{request.data}, 1, 2, index);
    request.data[3] = static_cast<std::uint8_t>(sub);
    write_le(MutableBytes{request.data}, 4, size, bits);
    return request;
}

/// Returns whether the written value is outside the entry's fixed range or list of allowed values. Ignores a limit that
/// is the value of another entry.
inline bool is_beyond_fixed_range(const ObjectDictionary& objects, const ExpeditedWrite& write) {
    const EntryRow& row = *write.entry.row;
    const bool is_number = write.value() >= -3.4e38 && write.value() <= 3.4e38;
    if (!is_number || (row.type == DataType::boolean && write.bits > 1U)) {
        return true;
    }
    if (row.limit == no_limit) {
        return false;
    }
    const LimitRow& limits = objects.tables().limits[row.limit];
    if (limits.minimum.kind == LimitKind::list) {
        return objects.check_bits(row, write.bits) != AbortCode::none;
    }
    const auto end = [&write](const Limit& limit) { return ExpeditedWrite{write.entry, limit.bits}.value(); };
    const bool has_minimum = limits.minimum.kind == LimitKind::value;
    const bool is_zero = limits.minimum.kind == LimitKind::value_or_zero && write.bits == 0;
    const bool is_low = (has_minimum || limits.minimum.kind == LimitKind::value_or_zero) &&
                        write.value() < end(limits.minimum) && !is_zero;
    return is_low || (limits.maximum.kind == LimitKind::value && write.value() > end(limits.maximum));
}

}  // namespace canproof::fuzz
