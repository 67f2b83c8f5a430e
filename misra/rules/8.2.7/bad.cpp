// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdint>
std::uintptr_t address(const int* const place) {
    return reinterpret_cast<std::uintptr_t>(place);  // flagged
}
