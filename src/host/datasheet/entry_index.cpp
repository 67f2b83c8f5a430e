// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/entry_index.hpp"

namespace canproof::host {

std::string full_name(const NamedEntry& named) {
    const std::string& object = named.object->name;
    const std::string& entry = named.entry->name;
    const bool single = named.object->kind == Object::Kind::var;
    return single ? object : entry.rfind(object, 0) == 0 ? entry : object + " " + entry;
}

EntryIndex::EntryIndex(const Part& part) {
    for (const Object& object : part.objects) {
        for (const Entry& entry : object.entries) {
            entries_[key(object.index, entry.subindex)] = {&object, &entry};
        }
    }
}

const NamedEntry* EntryIndex::named(const unsigned index, const unsigned sub) const {
    const auto found = entries_.find(key(index, sub));
    return found == entries_.end() ? nullptr : &found->second;
}

std::optional<std::uint32_t> EntryIndex::number(const unsigned index, const unsigned sub,
                                                const unsigned node_id) const {
    const NamedEntry* found = named(index, sub);
    const auto* whole = found == nullptr ? nullptr : std::get_if<std::int64_t>(&found->entry->value);
    return whole == nullptr
               ? std::nullopt
               : std::optional{static_cast<std::uint32_t>(*whole) + (found->entry->node_id ? node_id : 0U)};
}

}  // namespace canproof::host
