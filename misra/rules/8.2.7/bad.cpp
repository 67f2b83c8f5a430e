// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstdint>
std::uintptr_t address(const int* const place) {
    return reinterpret_cast<std::uintptr_t>(place);  // flagged
}
