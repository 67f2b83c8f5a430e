// From a measured value to the whole number that goes on the bus (AX060805, 4.3.33, 4.3.36), and back.
#pragma once

#include <cstdint>

namespace canproof::ax060805 {

struct CountScale {
    std::uint16_t digits{1U};  ///< counts of one unit
    float offset{0.0F};        ///< counts
};

/// `value` times the digits, plus the offset, rounded to nearest (halves away from zero) and saturated to INTEGER16.
/// NaN gives 0.
std::int16_t count_value(float value, const CountScale& scale) noexcept;

/// Rounded to nearest, halves up, 0…65535; NaN gives 0.
std::uint16_t whole_milliseconds(float milliseconds) noexcept;

/// How a received value is scaled (4.3.20, 4.3.21).
struct ReceivedScale {
    std::uint16_t digits{1000U};  ///< 1000 divided by the counts of one unit
    float offset{0.0F};           ///< counts
};

/// A received value in its unit: the count plus the offset, divided by the counts of one unit.
float value_of_count(std::int16_t count, const ReceivedScale& scale) noexcept;

}  // namespace canproof::ax060805
