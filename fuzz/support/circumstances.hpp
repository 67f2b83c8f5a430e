// SPDX-License-Identifier: Apache-2.0
// The circumstances in which a fuzz target runs an input on a device.
#pragma once

#include <cstdint>

namespace canproof::fuzz {

/// The start time and the initial content of RAM of a run. They must not change the result.
struct Circumstances {
    std::uint64_t begins_us{0};  ///< the time at power-on
    std::uint8_t garbage{0};     ///< the byte that fills the RAM of the device before its start
};

/// Circumstances of a late start with dirty RAM. The start time is a multiple of 24 s, so that each LED pattern begins
/// a new period at the start. 1.28 s later, the low 32 bits of the time in microseconds become 0.
constexpr Circumstances late_and_dirty{94'488'000'000U, 0xA5};

}  // namespace canproof::fuzz
