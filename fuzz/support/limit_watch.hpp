// SPDX-License-Identifier: Apache-2.0
// Finds the entries that may have left their limits since the last check. A device has a thousand entries, and an event
// changes only a few of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <vector>

#include "firmware/canopen/object_dictionary.hpp"
#include "fuzz/support/entries.hpp"

namespace canproof::fuzz {

/// Maps each byte of a dictionary's image to its entry, and each entry to the entries whose limit it is.
class LimitIndex {
  public:
    explicit LimitIndex(const ObjectDictionary& objects) : owners_(objects.image().size(), no_entry) {
        std::map<std::uint32_t, std::size_t> numbers;
        for_each_entry(objects, [&](const EntryRef& entry) {
            numbers[entry.index * 0x100U + entry.row->subindex] = entries_.size();
            if (!entry.may(rights::constant)) {
                std::fill_n(owners_.begin() + entry.row->offset, entry.row->size, entries_.size());
            }
            entries_.push_back(entry);
        });
        limited_.resize(entries_.size());
        for (std::size_t number = 0; number < entries_.size(); ++number) {
            const EntryRow& row = *entries_[number].row;
            if (row.limit == no_limit) {
                continue;
            }
            const LimitRow& limits = objects.tables().limits[row.limit];
            for (const Limit& one : {limits.minimum, limits.maximum}) {
                const bool is_same = (one.bits & 0xFFU) == same_subindex;
                const auto found = numbers.find(is_same ? (one.bits & ~0xFFU) | row.subindex : one.bits);
                if (one.kind == LimitKind::entry && found != numbers.end()) {
                    limited_[found->second].push_back(number);
                }
            }
        }
    }

  private:
    friend class LimitWatch;
    static constexpr std::size_t no_entry = SIZE_MAX;

    std::vector<EntryRef> entries_;
    std::vector<std::size_t> owners_;  ///< for each byte of the image, the number of its entry
    /// for each entry, the numbers of the entries whose limit it is
    std::vector<std::vector<std::size_t>> limited_;
};

class LimitWatch {
  public:
    /// Calls `visit(entry)` for each entry whose bytes have changed since the last call, and for each entry whose limit
    /// is one of the changed entries. The first call visits all entries.
    template <typename Visit>
    void visit_changed(const LimitIndex& index, const ObjectDictionary& objects, const Visit& visit) {
        const ByteView image = objects.image();
        if (seen_.size() != image.size()) {
            seen_.assign(image.data(), image.data() + image.size());
            std::for_each(index.entries_.begin(), index.entries_.end(), visit);
            return;
        }
        for (std::size_t at = 0; at < seen_.size(); at += stride) {
            const std::size_t count = std::min(stride, seen_.size() - at);
            const bool is_whole = count == stride;
            if (is_whole ? strides_differ(seen_.data() + at, image.data() + at)
                         : !std::equal(image.data() + at, image.data() + at + count, seen_.data() + at)) {
                visit_owners(index, image, at, count, visit);
                std::memcpy(seen_.data() + at, image.data() + at, count);
            }
        }
    }

  private:
    static constexpr std::size_t stride = 64;  ///< bytes that are compared at once

    /// Returns whether the bytes of one stride differ. Does not call memcmp(), because libFuzzer and the sanitizers
    /// observe each of its calls.
    static bool strides_differ(const std::uint8_t* a, const std::uint8_t* b) {
        std::array<std::uint64_t, stride / sizeof(std::uint64_t)> left;
        std::array<std::uint64_t, stride / sizeof(std::uint64_t)> right;
        std::memcpy(left.data(), a, stride);
        std::memcpy(right.data(), b, stride);
        std::uint64_t difference = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            difference |= left[i] ^ right[i];
        }
        return difference != 0;
    }
    template <typename Visit>
    void visit_owners(const LimitIndex& index, ByteView image, std::size_t at, std::size_t count,
                      const Visit& visit) const {
        std::size_t last = LimitIndex::no_entry;
        for (std::size_t i = at; i < at + count; ++i) {
            const std::size_t owner = index.owners_[i];
            if (seen_[i] == image[i] || owner == LimitIndex::no_entry || owner == last) {
                continue;
            }
            last = owner;
            visit(index.entries_[owner]);
            for (const std::size_t number : index.limited_[owner]) {
                visit(index.entries_[number]);
            }
        }
    }

    std::vector<std::uint8_t> seen_;
};

}  // namespace canproof::fuzz
