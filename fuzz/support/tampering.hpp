// SPDX-License-Identifier: Apache-2.0
// Tracks which parts of a memory contain bytes that the device did not write. After an interrupted write to such a
// part, the stored set may be neither the old nor the new one, because the write may have made damaged data valid.
#pragma once

#include <cstddef>
#include <vector>

#include "fuzz/support/journal_memory.hpp"
#include "properties/support/same_bytes.hpp"

namespace canproof::fuzz {

class Tampering {
  public:
    /// Adds a part that the device writes as a whole, a bank or a slot. Returns its number.
    std::size_t add_part(std::size_t begin, std::size_t size) {
        parts_.push_back({begin, size, false});
        return parts_.size() - 1;
    }

    /// Records a change that the device did not make. A part with the same byte everywhere counts as erased.
    void note_edit(const Image& before, const Image& after) {
        for (Part& part : parts_) {
            const std::uint8_t* const begin = after.data() + part.begin;
            const bool erased = same_bytes(begin, begin + 1, part.size - 1);
            part.foreign = !erased && (part.foreign || changed(part, before, after));
        }
    }
    /// Notes a complete write by the device.
    void note_write(const Image& before, const Image& after) {
        for (Part& part : parts_) {
            part.foreign = part.foreign && !changed(part, before, after);
        }
    }
    bool is_foreign(std::size_t part) const { return parts_[part].foreign; }

  private:
    struct Part {
        std::size_t begin;
        std::size_t size;
        bool foreign;
    };

    static bool changed(const Part& part, const Image& before, const Image& after) {
        return before.size() != after.size() ||
               !same_bytes(before.data() + part.begin, after.data() + part.begin, part.size);
    }

    std::vector<Part> parts_;
};

}  // namespace canproof::fuzz
