// SPDX-License-Identifier: Apache-2.0
// A small slave for a fuzz target that saves and loads its parameters often. It stores a fifth of the bytes of the
// conformance slave, but each type of value, each parameter group, and COB-IDs with the node-ID.
#pragma once

#include <algorithm>
#include <array>

#include "tests/support/slave_register.hpp"

namespace canproof::fuzz {

/// Returns a copy of an object of the conformance slave, with the sub-indices up to `last` only.
inline host::Object some_entries(std::uint16_t index, std::uint8_t last) {
    const std::vector<host::Object>& objects = test::slave_part().objects;
    host::Object object =
        *std::find_if(objects.begin(), objects.end(), [index](const host::Object& one) { return one.index == index; });
    const auto behind = std::find_if(object.entries.begin(), object.entries.end(),
                                     [last](const host::Entry& one) { return one.subindex > last; });
    object.entries.erase(behind, object.entries.end());
    return object;
}

/// Returns a copy of an object with another index.
inline host::Object renumbered(host::Object object, std::uint16_t index) {
    object.index = index;
    return object;
}

/// Returns the small slave. Its only PDO is an RPDO that is switched off and has two mapped values. Unlike the
/// conformance slave, it has application parameters (from 6000h on).
inline host::Part small_slave() {
    struct Kept {
        std::uint16_t index;
        std::uint8_t last;
    };
    constexpr std::array<Kept, 22> kept{{{0x1000, 0}, {0x1001, 0}, {0x1003, 2}, {0x1010, 4}, {0x1011, 4}, {0x1014, 0},
                                         {0x1017, 0}, {0x1018, 4}, {0x1020, 2}, {0x1029, 2}, {0x1400, 5}, {0x1600, 2},
                                         {0x2000, 2}, {0x2002, 2}, {0x2201, 0}, {0x2202, 0}, {0x2203, 0}, {0x2204, 0},
                                         {0x2205, 0}, {0x2206, 0}, {0x2300, 0}, {0x2301, 0}}};
    host::Part part = test::slave_part();
    part.objects.clear();
    for (const Kept& one : kept) {
        part.objects.push_back(some_entries(one.index, one.last));
        if (one.index == 0x1400) {
            part.objects.back().entries.at(1).value = std::int64_t{0x80000200};
        }
    }
    part.objects.push_back(renumbered(some_entries(0x2100, 2), 0x6000));
    part.objects.push_back(renumbered(some_entries(0x2207, 0), 0x6200));
    return part;
}

}  // namespace canproof::fuzz
