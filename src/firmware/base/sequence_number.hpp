// SPDX-License-Identifier: Apache-2.0
// Sequence numbers of saves. They wrap after 2^32 saves.
#pragma once

#include <cstdint>

namespace canproof {

/// Returns whether the save with sequence number `a` is later than the save with number `b`. The two saves must be less
/// than 2^31 saves apart.
constexpr bool is_newer(const std::uint32_t a, const std::uint32_t b) noexcept {
    constexpr std::uint32_t half = 0x80000000U;
    return (a != b) && ((a - b) < half);
}

}  // namespace canproof
