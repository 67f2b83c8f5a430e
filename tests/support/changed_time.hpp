// SPDX-License-Identifier: Apache-2.0
// Changes a time that an object keeps in RAM, as a fault of one bit does.
#pragma once

#include <cstddef>
#include <cstring>

#include "firmware/base/time.hpp"

namespace canproof::test {

/// Moves each time in `object` that equals `time` about 9 years ahead: inverts its bit 48, which stands for 2^48 us.
/// Returns the number of these times.
template <typename Object>
std::size_t move_far_ahead(Object& object, Instant time) {
    constexpr std::size_t byte_of_bit_48 = 6;
    auto* const bytes = reinterpret_cast<unsigned char*>(&object);
    std::size_t found = 0;
    for (std::size_t at = 0; at + sizeof time <= sizeof object; at += sizeof time) {
        if (std::memcmp(bytes + at, &time, sizeof time) == 0) {
            bytes[at + byte_of_bit_48] ^= 1U;
            ++found;
        }
    }
    return found;
}

}  // namespace canproof::test
