// SPDX-License-Identifier: Apache-2.0
// Converts measured values to the whole numbers sent on the bus (AX060805, 4.3.33, 4.3.36) and received numbers back.
#pragma once

#include <cstdint>

namespace canproof::ax060805 {

struct CountScale {
    std::uint16_t digits{1U};  ///< counts per unit
    float offset{0.0F};        ///< offset in counts
};

/// Returns `value` times the counts per unit plus the offset, rounded to nearest (halves away from zero) and saturated
/// to INTEGER16. NaN gives 0.
std::int16_t count_value(float value, const CountScale& scale) noexcept;

/// Rounds `milliseconds` to nearest, halves up, and clamps to 0…65535; NaN gives 0.
std::uint16_t whole_milliseconds(float milliseconds) noexcept;

/// The scaling of a received value (4.3.20, 4.3.21).
struct ReceivedScale {
    std::uint16_t digits{1000U};  ///< 1000 divided by the counts per unit
    float offset{0.0F};           ///< counts
};

/// Returns a received value in its unit: the count plus the offset, divided by the counts per unit.
float value_of_count(std::int16_t count, const ReceivedScale& scale) noexcept;

}  // namespace canproof::ax060805
