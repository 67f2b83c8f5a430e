// SPDX-License-Identifier: Apache-2.0
// Iterates over the entries of the dictionary of a device.
#pragma once

#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::fuzz {

template <typename Visit>
void for_each_entry(const ObjectDictionary& objects, const Visit& visit) {
    for (const ObjectRow& object : objects.tables().objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            visit(EntryRef{&objects.tables().entries[object.first_entry + i], object.index});
        }
    }
}

}  // namespace canproof::fuzz
