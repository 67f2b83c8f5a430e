// From a measured value to the whole number that goes on the bus (AX060805, 4.3.33, 4.3.36).
#pragma once

#include <cstdint>

namespace canproof {

struct CountScale {
    std::uint16_t digits{1U};  ///< counts of one unit
    float offset{0.0F};        ///< counts
};

/// `value` times the digits, plus the offset, rounded to nearest (halves away from zero) and saturated to INTEGER16.
/// What is no number gives 0.
std::int16_t count_value(float value, const CountScale& scale) noexcept;

/// Rounded to nearest, halves up, 0…65535; what is no number gives 0.
std::uint16_t whole_milliseconds(float milliseconds) noexcept;

/// The reverse for a received value: (count + offset) / digits. 0 digits count as 1.
float value_of_count(std::int16_t count, const CountScale& scale) noexcept;

}  // namespace canproof
