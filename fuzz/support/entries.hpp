// The entries of a device's dictionary, one after the other and by number.
#pragma once

#include <algorithm>
#include <optional>

#include "firmware/base/bytes.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::fuzz {

template <typename Visit>
void for_each_entry(const ObjectDictionary& objects, const Visit& visit) {
    for (const ObjectRow& object : objects.tables().objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            visit(EntryRef{&objects.tables().entries[object.first_entry + i], object.index});
        }
    }
}

/// An expedited write to `node` of the right length, so that values matter and not addresses. `data`: two bytes that
/// choose the entry, four for its value. Nothing when that entry cannot be written so.
inline std::optional<Frame> expedited_write(const DictionaryTables& tables, std::uint32_t node,
                                            const std::uint8_t* data) {
    const std::size_t chosen = (data[0] + 256U * data[1]) % tables.entries.count;
    const EntryRow& entry = tables.entries[chosen];
    for (const ObjectRow& object : tables.objects) {
        const bool holds = chosen >= object.first_entry && chosen < std::size_t{object.first_entry} + object.count;
        if (holds && entry.size >= 1 && entry.size <= 4) {
            Frame write = data_frame(0x600U + node, 8);
            write.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - entry.size) << 2U));
            write_le(MutableBytes{write.data}, 1, 2, object.index);
            write.data[3] = entry.subindex;
            std::copy_n(data + 2, entry.size, write.data.begin() + 4);
            return write;
        }
    }
    return std::nullopt;
}

}  // namespace canproof::fuzz
