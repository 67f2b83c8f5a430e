// SPDX-License-Identifier: Apache-2.0
// Finds the entries of a dictionary by index and sub-index.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Bits of a COB-ID entry.
constexpr std::uint32_t cob_id_switched_off = 0x80000000;
constexpr std::uint32_t cob_id_extended = 0x20000000;

struct NamedEntry {
    const Object* object{nullptr};
    const Entry* entry{nullptr};
};

/// Returns the name of the object, followed by the name of its entry. Returns only the entry's name if it begins with
/// the object's name, and only the object's name for a VAR.
std::string full_name(const NamedEntry& named);

class EntryIndex {
  public:
    /// Keeps pointers into `part`, which must outlive the index.
    explicit EntryIndex(const Part& part);

    static unsigned key(unsigned index, unsigned sub) { return (index << 8U) | sub; }
    /// Returns the entry with this index and sub-index; nullptr when there is none.
    const NamedEntry* named(unsigned index, unsigned sub) const;
    /// Returns the default of an entry at this node-ID. Returns nothing when the entry does not exist or its default is
    /// no whole number.
    std::optional<std::uint32_t> number(unsigned index, unsigned sub, unsigned node_id) const;
    /// Returns all entries; key() gives their keys.
    const std::map<unsigned, NamedEntry>& all() const { return entries_; }

  private:
    std::map<unsigned, NamedEntry> entries_;
};

}  // namespace canproof::host
