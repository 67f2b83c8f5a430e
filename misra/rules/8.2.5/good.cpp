// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <cstdint>
#include <cstring>

float as_float(const std::uint32_t bits) {
    float value{};
    static_cast<void>(std::memcpy(&value, &bits, sizeof value));
    return value;
}

const void* as_untyped(const int* const place) { return static_cast<const void*>(place); }
