// The entries of a dictionary by index and sub-index.
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

/// Object and entry in one name; the entry alone where it repeats the object's name.
std::string full_name(const NamedEntry& named);

class EntryIndex {
  public:
    /// `part` must outlive it.
    explicit EntryIndex(const Part& part);

    static unsigned key(unsigned index, unsigned sub) { return (index << 8U) | sub; }
    /// nullptr without such an entry.
    const NamedEntry* named(unsigned index, unsigned sub) const;
    /// Default of an entry at this node-ID; nothing without the entry or a whole number.
    std::optional<std::uint32_t> number(unsigned index, unsigned sub, unsigned node_id) const;
    /// By key.
    const std::map<unsigned, NamedEntry>& all() const { return entries_; }

  private:
    std::map<unsigned, NamedEntry> entries_;
};

}  // namespace canproof::host
