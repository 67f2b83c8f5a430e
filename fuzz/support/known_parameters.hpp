// SPDX-License-Identifier: Apache-2.0
// The parameters that the naive model of a device knows. Makes write requests for these parameters from the bytes of a
// fuzz input.
#pragma once

#include <vector>

#include "fuzz/support/device_record.hpp"
#include "fuzz/support/expedited_write.hpp"

namespace canproof::fuzz {

class KnownParameters {
  public:
    /// Collects the entries that the model knows. An entry is known if `is_known()` is true for a write of its present
    /// value.
    template <typename IsKnown>
    KnownParameters(const ObjectDictionary& objects, const IsKnown& is_known, unsigned node) {
        for (const ObjectRow& object : objects.tables().objects) {
            std::vector<EntryRef> known;
            for (std::size_t i = 0; i < object.count; ++i) {
                const EntryRef entry{&objects.tables().entries[object.first_entry + i], object.index};
                const bool is_short = entry.row->size >= 1 && entry.row->size <= 4;
                const auto bits = static_cast<std::uint32_t>(is_short ? objects.bits(*entry.row) : 0U);
                if (is_short && entry.may(rights::write) && is_known(request(node, entry, bits))) {
                    known.push_back(entry);
                }
            }
            if (!known.empty()) {
                objects_.push_back(known);
            }
        }
    }

    /// Returns a write to a known parameter: data[0] chooses the object, data[1] its entry, data[2…6] the value.
    Frame write(unsigned node, const std::uint8_t* data) const {
        const std::vector<EntryRef>& entries = objects_[data[0] % objects_.size()];
        const EntryRef& entry = entries[data[1] % entries.size()];
        return request(node, entry, value_for(*entry.row, data + 2));
    }

  private:
    static Frame request(unsigned node, const EntryRef& entry, std::uint32_t bits) {
        std::uint32_t value = bits;
        if (entry.index == 0x1003) {
            value = 0;
        } else if (entry.index == 0x1010 || entry.index == 0x1011) {
            value = entry.index == 0x1010 ? 0x65766173U : 0x64616F6CU;  // the signatures "save" and "load"
        }
        return write_request(node, entry.index, entry.row->subindex, entry.row->size, value);
    }
    /// Returns a value made from `data`. For a REAL32, it is a plain decimal number; for any other type, all bits of
    /// `data` or a small number.
    static std::uint32_t value_for(const EntryRow& row, const std::uint8_t* data) {
        if (row.type == DataType::real32) {
            const std::array<std::uint8_t, 5> plain{data[0], data[1], 0, 0, static_cast<std::uint8_t>(data[4] | 4U)};
            return bit_cast<std::uint32_t>(value_of<float>(plain.data()));
        }
        const std::uint32_t all = read_u32(ByteView{data, 4}, 0);
        switch (data[4] % 4U) {
            case 0:
                return all;
            case 1:
                return data[0];
            case 2:
                return data[0] % 4U;
            default:
                return data[0] * 4U;
        }
    }

    std::vector<std::vector<EntryRef>> objects_;  ///< the known entries of each object
};

}  // namespace canproof::fuzz
