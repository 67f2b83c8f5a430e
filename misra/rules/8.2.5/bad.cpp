// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstdint>

float as_float(std::uint32_t& bits) {
    return reinterpret_cast<float&>(bits);  // flagged
}

std::uintptr_t address_of(const int* const place) {
    return reinterpret_cast<std::uintptr_t>(place);  // flagged
}
