// SPDX-License-Identifier: Apache-2.0
// The alterations that `canproof mutate` makes to cells, the values in generated tables. Only test programs that are
// built with changeable cells (preset `mutation`) contain the list of alterations.
#pragma once

#include <cstddef>
#include <cstdint>

namespace canproof::host {

/// One change of one cell (a value in a generated table): the low `size` bytes (1 to 8) of `bits` replace the bytes at
/// `address`.
struct Alteration {
    const char* item;    ///< id of the object, table or constant to which the cell belongs
    const char* cell;    ///< `sub 1 default`, `row 3 action` …
    const char* change;  ///< old and new value: `5 -> 6`
    void* address;
    std::size_t size;
    std::uint64_t bits;
};

struct Alterations {
    const Alteration* first;
    std::size_t count;

    const Alteration* begin() const { return first; }
    const Alteration* end() const { return first + count; }
};

/// Returns all alterations in the order of the register. The program speccompiler generates this function from the
/// register.
Alterations generated_alterations();

}  // namespace canproof::host
