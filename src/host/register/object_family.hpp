// SPDX-License-Identifier: Apache-2.0
// Families of objects: one [[object]] with `repeat` describes several objects of the dictionary.
#pragma once

#include <cstdint>

#include "host/register/toml_item.hpp"

namespace canproof::host {

/// The numbers of a family's members, and the step from the index of one member to the index of the next.
struct ObjectFamily {
    std::int64_t first{1};
    std::int64_t last{1};
    std::int64_t step{0};
    bool decimal{false};  ///< whether the index has the decimal digits of the member's number: 10 gives 10h, not 0Ah

    std::int64_t offset(std::int64_t n) const;
};

/// One object of a family whose members are numbered from `first` to `last`.
struct FamilyMember {
    std::int64_t n;
    std::int64_t first;
    std::int64_t last;
};

/// Reads `repeat` of an [[object]]. Returns a family of one member when it is missing.
ObjectFamily read_family(TomlItem& item);

/// Checks that a default such as `{ 1 = 0, 2 = 5 }` contains each member of the family and no other number.
void check_family_default(TomlItem& item, const FamilyMember& member);

}  // namespace canproof::host
