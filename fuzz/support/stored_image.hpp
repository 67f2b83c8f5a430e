// SPDX-License-Identifier: Apache-2.0
// Copies the stored values of a device from its image in RAM.
#pragma once

#include <algorithm>
#include <vector>

#include "firmware/canopen/object_dictionary.hpp"
#include "fuzz/support/require.hpp"
#include "properties/support/naive_store.hpp"

namespace canproof::fuzz {

/// The stored values in the image of a device: copies them into one row, as a bank has them.
class StoredImage {
  public:
    StoredImage(const naive_store::Format& format, const DictionaryTables& tables) : format_{format} {
        for (const ObjectRow& object : tables.objects) {
            for (std::size_t i = 0; i < object.count; ++i) {
                const EntryRow& row = tables.entries[object.first_entry + i];
                if (row.may(rights::stored)) {
                    add(row.offset, row.size);
                }
            }
        }
        require(size_ == format.payload_size(), "every stored value has a place");
    }

    /// Copies the values; texts are padded with zeros after their end.
    void copy(ByteView image, naive_store::Bytes& to) const {
        for (const Run& run : runs_) {
            std::copy_n(image.data() + run.offset, run.size, to.data() + run.at);
        }
        format_.end_texts(to);
    }

  private:
    /// Values that follow each other in the image and in the bank.
    struct Run {
        std::size_t offset;
        std::size_t at;
        std::size_t size;
    };
    void add(std::size_t offset, std::size_t size) {
        if (!runs_.empty() && runs_.back().offset + runs_.back().size == offset) {
            runs_.back().size += size;
        } else {
            runs_.push_back({offset, size_, size});
        }
        size_ += size;
    }

    const naive_store::Format& format_;
    std::vector<Run> runs_;
    std::size_t size_{0};
};

}  // namespace canproof::fuzz
