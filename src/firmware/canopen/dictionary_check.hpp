// SPDX-License-Identifier: Apache-2.0
// Checks the properties of a generated dictionary on which the services rely. The C++ compiler evaluates these checks
// when it compiles the tables.
#pragma once

#include "firmware/canopen/object_types.hpp"
#include "firmware/canopen/pdo_communication.hpp"

namespace canproof {

/// Returns whether an object is sound: its sub-indices ascend from 0, each entry refers to an existing row of limits,
/// and every value lies within the pool of constants or of defaults. Each short number has one to four bytes.
constexpr bool has_sound_entries(const DictionaryTables& tables, const ObjectRow& object) noexcept {
    std::uint32_t least{0U};  // the least sub-index that the next entry may have
    for (std::size_t i = 0U; i < object.count; ++i) {
        const EntryRow& row = tables.entries[object.first_entry + i];
        const bool constant = (row.rights & rights::constant) != 0U;
        const std::size_t pool = constant ? tables.constants.count : tables.defaults.count;
        const std::size_t end = std::size_t{row.offset} + row.size;
        const bool limited = row.limit != no_limit;
        const bool fits_word = (row.size >= 1U) && (row.size <= sizeof(std::uint32_t));
        if (is_short_number(row.type) && !fits_word) {
            return false;
        }
        if ((row.subindex < least) || (end > pool) || (limited && (row.limit >= tables.limits.count))) {
            return false;
        }
        least = row.subindex + std::uint32_t{1U};
    }
    return (object.count > 0U) && (tables.entries[object.first_entry].subindex == 0U);
}

/// Returns whether the settings begin at a multiple of four, end with the image, and include no value that a PDO
/// carries.
constexpr bool has_sound_settings(const DictionaryTables& tables) noexcept {
    constexpr std::size_t word = sizeof(std::uint32_t);
    const bool none = tables.settings_at >= tables.defaults.count;
    bool sound = none || (((tables.settings_at % word) == 0U) && ((tables.defaults.count % word) == 0U));
    for (const EntryRow& row : tables.entries) {
        const bool is_setting = ((row.rights & rights::constant) == 0U) && (row.offset >= tables.settings_at);
        sound = sound && (!is_setting || ((row.rights & (rights::rpdo | rights::tpdo)) == 0U));
    }
    return sound;
}

/// Returns whether a search in the hash table (`slots`) finds object `wanted`. The search takes the same steps as
/// ObjectDictionary::object_row().
constexpr bool is_found(const DictionaryTables& tables, const std::size_t wanted) noexcept {
    const std::size_t count = tables.slots.count;
    std::size_t slot = object_slot(tables.objects[wanted].index, tables.slot_factor, count);
    for (std::size_t step = 0U; step < count; ++step) {
        if (tables.slots[slot] == wanted) {
            return true;
        }
        if (tables.slots[slot] == no_object) {
            return false;
        }
        slot = (slot + 1U) & (count - 1U);
    }
    return false;
}

/// Returns whether a search for an absent object ends: the hash table has a free slot, and its number of slots is a
/// power of two.
constexpr bool has_free_slot(const DictionaryTables& tables) noexcept {
    const std::size_t count = tables.slots.count;
    return (count > tables.objects.count) && ((count & (count - 1U)) == 0U);
}

/// Returns whether the index is the communication parameter object of a PDO that the node does not serve: the objects
/// of this PDO would have no effect.
constexpr bool is_unserved_pdo(const PdoDirection direction, const std::size_t index) noexcept {
    constexpr std::size_t most_of_cia_301{512U};
    const std::size_t first = communication_object(direction, 0U);
    return (index >= (first + max_pdos)) && (index < (first + most_of_cia_301));
}

constexpr bool serves_its_pdos(const DictionaryTables& tables) noexcept {
    for (const ObjectRow& object : tables.objects) {
        if (is_unserved_pdo(PdoDirection::receive, object.index) ||
            is_unserved_pdo(PdoDirection::transmit, object.index)) {
            return false;
        }
    }
    return true;
}

/// Returns whether a dictionary is sound: the objects ascend, and their entries are sound and follow one another
/// without a gap. Each search for an index ends with the right result, the node serves all PDOs of the dictionary, and
/// the settings are sound.
constexpr bool is_sound(const DictionaryTables& tables) noexcept {
    std::uint32_t least{0U};
    std::size_t entry{0U};
    for (std::size_t i = 0U; i < tables.objects.count; ++i) {
        const ObjectRow& object = tables.objects[i];
        if ((object.index < least) || (object.first_entry != entry)) {
            return false;
        }
        if (!has_sound_entries(tables, object) || !is_found(tables, i)) {
            return false;
        }
        least = object.index + std::uint32_t{1U};
        entry += object.count;
    }
    return (entry == tables.entries.count) && has_free_slot(tables) && serves_its_pdos(tables) &&
           has_sound_settings(tables);
}

}  // namespace canproof
