// SPDX-License-Identifier: Apache-2.0
// Reads the memory that contains stored parameters as its format is described, without code of the firmware. Each of
// two banks has a header: magic "COP", a marker, layout, sequence number, groups, and a node-ID for each group. The
// values follow in the order of the dictionary, then a CRC-32 over header and values. For the CRC, the marker always
// counts as that of a committed bank.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "firmware/canopen/object_dictionary.hpp"
#include "properties/support/quick_crc32.hpp"
#include "properties/support/same_bytes.hpp"

namespace canproof::naive_store {

using Bytes = std::vector<std::uint8_t>;
using Address = std::pair<unsigned, unsigned>;  ///< index, sub-index

/// The values that a memory holds.
struct Values {
    unsigned groups{0};  ///< bit n is set if group n is saved
    Bytes bytes;         ///< all stored entries in the order of the dictionary; zeros for groups that are not saved

    bool operator==(const Values& other) const { return groups == other.groups && same_bytes(bytes, other.bytes); }
};

/// The values that a memory holds, and whether parameters were saved but cannot be loaded now.
struct Content {
    bool is_corrupt{false};
    Values values;
};

/// One entry that 1010h (store parameters) stores. Group 0 is communication, 1 application, 2 manufacturer.
struct Stored {
    Address address;
    std::size_t at;  ///< place of the value among all stored values
    std::size_t size;
    unsigned group;
    bool is_text;
    bool has_node_id;    ///< the default contains the node-ID
    std::uint64_t base;  ///< the default without the node-ID
};

/// Clears the bytes after the first zero of a visible string, which are not part of the value.
inline void end_text(std::uint8_t* text, std::size_t size) {
    std::fill(std::find(text, text + size, std::uint8_t{0}), text + size, std::uint8_t{0});
}

/// Returns the parameter group of an index: communication from 1000h, manufacturer from 2000h, application from 6000h
/// on.
inline unsigned group_of(unsigned index) {
    return index < 0x2000 ? 0U : index < 0x6000 ? 2U : 1U;
}

/// Returns the number that up to eight bytes represent, least significant byte first.
inline std::uint64_t number_of(const std::uint8_t* bytes, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < count && i < 8; ++i) {
        number |= std::uint64_t{bytes[i]} << (8 * i);
    }
    return number;
}

inline std::vector<Stored> stored_entries(const DictionaryTables& tables) {
    std::vector<Stored> all;
    std::size_t at = 0;
    for (const ObjectRow& object : tables.objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            const EntryRow& row = tables.entries[object.first_entry + i];
            if ((row.rights & rights::stored) != 0) {
                all.push_back({{object.index, row.subindex},
                               at,
                               row.size,
                               group_of(object.index),
                               row.type == DataType::visible_string,
                               (row.rights & rights::node_id) != 0,
                               number_of(tables.defaults.rows + row.offset, row.size)});
                at += row.size;
            }
        }
    }
    return all;
}

inline std::uint32_t number_at(const Bytes& image, std::size_t at) {
    return image[at] + 0x100U * image[at + 1] + 0x10000U * image[at + 2] + 0x1000000U * image[at + 3];
}
inline void put_number(Bytes& image, std::size_t at, std::uint32_t number) {
    for (std::size_t i = 0; i < 4; ++i) {
        image[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
    }
}

constexpr std::uint32_t magic = 0x53504F43;
constexpr std::uint8_t committed = 'S';
constexpr std::uint8_t without_effect = '-';  ///< the marker of an invalid bank
constexpr std::size_t marker_at = 3;
constexpr std::size_t header_size = 16;
constexpr std::uint64_t identifiers = 2048;  ///< number of identifiers of 11 bits

/// The format of the stored parameters of a device with the dictionary `tables`.
class Format {
  public:
    explicit Format(const DictionaryTables& tables) : entries_{stored_entries(tables)}, layout_{tables.layout} {
        for (const Stored& one : entries_) {
            Part& part = parts_[one.group];
            part.begin = part.size == 0 ? one.at : part.begin;
            part.size += one.size;
            payload_ += one.size;
            if (one.is_text) {
                texts_.push_back(one);
            }
            if (one.has_node_id) {
                cob_ids_.push_back(one);
            }
        }
    }

    const std::vector<Stored>& entries() const { return entries_; }
    std::size_t bank_size() const { return header_size + payload_ + 4; }
    std::size_t payload_size() const { return payload_; }
    std::size_t checked_size() const { return header_size + payload_; }

    /// Returns whether the bank has values that can be loaded: it is neither marked as invalid nor blank, and its magic
    /// word, layout and CRC are right. Any marker except the one for `invalid` is accepted.
    bool is_sound(const Bytes& image, unsigned bank) const {
        constexpr std::uint32_t without_marker = 0x00FFFFFF;
        const std::size_t at = bank * bank_size();
        const bool has_magic = (number_at(image, at) & without_marker) == (magic & without_marker);
        if (!has_magic || image[at + marker_at] == without_effect || number_at(image, at + 4) != layout_) {
            return false;
        }
        std::array<std::uint8_t, header_size> header{};
        std::copy_n(image.data() + at, header_size, header.begin());
        header[marker_at] = committed;
        QuickCrc32 crc;
        crc.add(header.data(), header_size);
        crc.add(image.data() + at + header_size, payload_);
        return number_at(image, at + checked_size()) == crc.value();
    }
    bool is_committed(const Bytes& image, unsigned bank) const {
        return image[bank * bank_size() + marker_at] == committed;
    }
    bool is_unused(const Bytes& image, unsigned bank) const {
        return image[bank * bank_size() + marker_at] == without_effect || is_blank(image, bank);
    }
    bool is_blank(const Bytes& image, unsigned bank) const {
        const std::uint8_t* const begin = image.data() + bank * bank_size();
        const auto all = [begin](std::uint8_t wanted) {
            return std::all_of(begin, begin + header_size, [wanted](std::uint8_t byte) { return byte == wanted; });
        };
        return all(0x00) || all(0xFF);
    }
    /// Returns the valid bank that was written last. Returns nothing if a bank is damaged: marked as committed but not
    /// sound. The sequence number after FFFFFFFFh is 0.
    std::optional<unsigned> bank_in_use(const Bytes& image) const {
        const bool first = is_sound(image, 0);
        const bool second = is_sound(image, 1);
        if ((!first && is_committed(image, 0)) || (!second && is_committed(image, 1))) {
            return std::nullopt;
        }
        if (first && second) {
            const std::uint32_t ahead = number_at(image, bank_size() + 8) - number_at(image, 8);
            return ahead != 0 && ahead < 0x80000000U ? 1U : 0U;
        }
        return first ? std::optional{0U} : second ? std::optional{1U} : std::nullopt;
    }
    /// If the identifier of a saved COB-ID is `base` plus the node-ID at the save, changes it to `base` plus `node_id`.
    /// The bits above the identifier stay (requirements CO-PDO-035, CO-PDO-061).
    static void follow(std::uint8_t* cob_id, const Stored& one, unsigned saved_node_id, unsigned node_id) {
        const std::uint64_t base = one.base % identifiers;
        const std::uint64_t saved = number_of(cob_id, one.size);
        if (saved % identifiers == base + saved_node_id) {
            const std::uint64_t now = saved / identifiers * identifiers + base + node_id;
            for (std::size_t i = 0; i < one.size; ++i) {
                cob_id[i] = static_cast<std::uint8_t>(now >> (8 * i));
            }
        }
    }
    /// Returns the content of a memory without stored values.
    Content nothing() const { return {false, {0, Bytes(payload_, 0)}}; }
    /// Reads what a memory holds, as node `node_id` loads it. Writes to the memory of `content`, which nothing() made,
    /// so that a fuzz target allocates nothing.
    void read(const Bytes& image, unsigned node_id, Content& content) const {
        const auto bank = bank_in_use(image);
        content.is_corrupt = !bank && !(is_unused(image, 0) && is_unused(image, 1));
        const std::size_t at = bank.value_or(0) * bank_size();
        Values& values = content.values;
        values.groups = bank ? image[at + 12] & 7U : 0U;
        for_each_part(values.groups, [&](const Part& part) {
            std::copy_n(image.data() + at + header_size + part.begin, part.size, values.bytes.data() + part.begin);
        });
        clear(~values.groups, values);
        for (const Stored& one : cob_ids_) {
            if (((values.groups >> one.group) & 1U) != 0) {
                follow(values.bytes.data() + one.at, one, image[at + 13 + one.group], node_id);
            }
        }
        end_texts(values.bytes);
    }
    /// Clears the bytes after the end of each visible string.
    void end_texts(Bytes& payload) const {
        for (const Stored& one : texts_) {
            end_text(payload.data() + one.at, one.size);
        }
    }
    /// Replaces the values of some groups by those of `payload`. These groups count as saved.
    void take(unsigned groups, const Bytes& payload, Values& values) const {
        values.groups |= groups;
        for_each_part(groups, [&](const Part& part) {
            std::copy_n(payload.data() + part.begin, part.size, values.bytes.data() + part.begin);
        });
    }
    /// Removes the values of some groups.
    void clear(unsigned groups, Values& values) const {
        values.groups &= ~groups;
        for_each_part(groups, [&](const Part& part) {
            std::fill_n(values.bytes.data() + part.begin, part.size, std::uint8_t{0});
        });
    }
    /// Writes a valid header and CRC to the bank, as if a save had written its present values.
    void make_sound(Bytes& image, unsigned bank, std::uint32_t sequence) const {
        const std::size_t at = bank * bank_size();
        put_number(image, at, magic);
        put_number(image, at + 4, layout_);
        put_number(image, at + 8, sequence);
        QuickCrc32 crc;
        crc.add(image.data() + at, checked_size());
        put_number(image, at + checked_size(), crc.value());
    }

  private:
    /// The place of a group's values among all stored values. They are together, because a group is a range of indices.
    struct Part {
        std::size_t begin{0};
        std::size_t size{0};
    };
    template <typename Action>
    void for_each_part(unsigned groups, const Action& action) const {
        for (unsigned group = 0; group < parts_.size(); ++group) {
            if (((groups >> group) & 1U) != 0) {
                action(parts_[group]);
            }
        }
    }

    std::vector<Stored> entries_;
    std::vector<Stored> texts_;    ///< entries with a visible string
    std::vector<Stored> cob_ids_;  ///< entries whose default contains the node-ID
    std::array<Part, 3> parts_{};
    std::uint32_t layout_;
    std::size_t payload_{0};
};

/// Returns the groups that a sub-index of 1010h (store parameters) and 1011h (restore default parameters) names (CiA
/// 301, 7.5.2.13); bit n is group n.
inline unsigned groups_of(unsigned subindex) {
    return subindex == 1 ? 7U : subindex == 2 ? 1U : subindex == 3 ? 2U : subindex == 4 ? 4U : 0U;
}

}  // namespace canproof::naive_store
