// SPDX-License-Identifier: Apache-2.0
// Returns the identifiers on which a device may send, according to its present dictionary.
#pragma once

#include <bitset>
#include <utility>
#include <vector>

#include "firmware/canopen/object_dictionary.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

using Identifiers = std::bitset<0x800>;

/// Returns the identifiers on which the device may send. Bit n of `answers_remote` is set if the device answers a
/// remote frame for RPDO n + 1, on the identifier of this RPDO.
inline Identifiers own_identifiers(const ObjectDictionary& objects, std::uint8_t node_id, std::uint8_t answers_remote) {
    constexpr std::uint32_t not_valid = 0x80000000U;
    constexpr std::uint32_t produces = 0x40000000U;  // bit 30 of 1005h (COB-ID SYNC): the device sends SYNC
    Identifiers own;
    own.set(0x7E4);  // identifier of LSS answers
    if (node_id == 0 || node_id > 127) {
        return own;
    }
    const auto id = [&objects](std::uint16_t index, std::uint8_t sub) { return objects.read(index, sub) & 0x7FFU; };
    own.set(0x580U + node_id);
    own.set(objects.has(0x100E, 0) ? id(0x100E, 0) : 0x700U + node_id);
    const bool has_emcy = objects.has(0x1014, 0);
    if (!has_emcy || (objects.read(0x1014, 0) & not_valid) == 0) {
        own.set(has_emcy ? id(0x1014, 0) : 0x080U + node_id);
    }
    if ((objects.read(0x1005, 0) & produces) != 0) {
        own.set(id(0x1005, 0));
    }
    for (std::uint16_t number = 0; number < 8; ++number) {
        const auto transmit = static_cast<std::uint16_t>(0x1800U + number);
        if (objects.has(transmit, 1) && (objects.read(transmit, 1) & not_valid) == 0) {
            own.set(id(transmit, 1));
        }
        const auto receive = static_cast<std::uint16_t>(0x1400U + number);
        if (((answers_remote >> number) & 1U) != 0 && (objects.read(receive, 1) & not_valid) == 0) {
            own.set(id(receive, 1));
        }
    }
    return own;
}

/// The values of a dictionary that own_identifiers() reads. Comparing these few COB-IDs takes less time than comparing
/// the whole image.
class IdentifierPlaces {
  public:
    using Values = std::vector<std::uint32_t>;

    explicit IdentifierPlaces(const ObjectDictionary& objects) {
        const auto add = [&](std::uint16_t index, std::uint8_t sub) {
            const EntryRef entry = objects.lookup(index, sub);
            if (entry.exists() && !entry.may(rights::constant)) {
                require(entry.row->size == sizeof(std::uint32_t), "a COB-ID has 32 bits");
                offsets_.push_back(entry.row->offset);
            }
        };
        add(0x1005, 0);
        add(0x100E, 0);
        add(0x1014, 0);
        for (std::uint16_t number = 0; number < 8; ++number) {
            add(static_cast<std::uint16_t>(0x1400U + number), 1);
            add(static_cast<std::uint16_t>(0x1800U + number), 1);
        }
    }
    /// Returns whether a value differs from its copy in `seen`, and updates `seen`.
    bool differ(ByteView image, Values& seen) const {
        std::uint32_t difference = seen.size() != offsets_.size() ? 1U : 0U;
        seen.resize(offsets_.size());
        for (std::size_t i = 0; i < offsets_.size(); ++i) {
            const auto value = static_cast<std::uint32_t>(load_le<sizeof(std::uint32_t)>(image, offsets_[i]));
            difference |= value ^ seen[i];
            seen[i] = value;
        }
        return difference != 0;
    }

  private:
    std::vector<std::size_t> offsets_;
};

/// Follows the identifiers of a device while its dictionary changes.
class IdentifierWatch {
  public:
    /// Takes the present dictionary and node-ID. Returns whether they have changed.
    bool follow(const IdentifierPlaces& places, const ObjectDictionary& objects, std::uint8_t node_id,
                std::uint8_t answers_remote) {
        const bool moved = std::exchange(node_, node_id) != node_id;
        // A dictionary without a variable COB-ID never differs from a copy without values.
        const bool is_first = std::exchange(is_first_, false);
        const bool changed = places.differ(objects.image(), seen_) || moved || is_first;
        if (changed) {
            before_ = std::exchange(own_, own_identifiers(objects, node_id, answers_remote));
        }
        is_new_ = changed;
        return changed;
    }
    /// Returns whether the device may send on the identifier, or was permitted to before the last call of follow().
    bool has(std::uint32_t id) const { return own_.test(id) || (is_new_ && before_.test(id)); }
    /// Forgets everything: the device is switched on.
    void restart() {
        own_.reset();
        seen_.clear();
        is_first_ = true;
    }

  private:
    IdentifierPlaces::Values seen_;
    Identifiers own_;
    Identifiers before_;
    std::uint8_t node_{0};
    bool is_new_{false};
    bool is_first_{true};
};

}  // namespace canproof::fuzz
