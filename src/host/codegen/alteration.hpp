// The cells that the register's compiler wrote, and how `canproof mutate` alters each of them. Exists only in test
// programs built with changeable cells (preset `mutation`).
#pragma once

#include <cstddef>
#include <cstdint>

namespace canproof::host {

/// One change of one cell: `size` (1…8) bytes at `address` become the low bytes of `bits`.
struct Alteration {
    const char* item;    ///< id of the requirement, object, table or constant
    const char* cell;    ///< `sub 1 default`, `row 3 action` …
    const char* change;  ///< `5 -> 6`
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

/// All of them in the register's order. Written by the compiler.
Alterations generated_alterations();

}  // namespace canproof::host
