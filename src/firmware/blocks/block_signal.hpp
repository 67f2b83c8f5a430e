// What one function block hands to another.
#pragma once

#include <cmath>
#include <cstdint>

namespace canproof {

enum class SignalState : std::uint8_t {
    valid,
    error,         ///< what feeds the block has failed
    not_available  ///< no source is chosen, or the block is off
};

/// A value in its physical unit, with the limits that belong to it (`lower` <= `upper`).
struct BlockSignal {
    double value{0.0};
    double lower{0.0};
    double upper{0.0};
    SignalState state{SignalState::not_available};

    constexpr bool is_valid() const noexcept { return state == SignalState::valid; }
    constexpr bool is_in_error() const noexcept { return state == SignalState::error; }
    constexpr bool is_available() const noexcept { return state != SignalState::not_available; }
};

/// Ten to the number of decimal digits, 0…4; more count as 4.
constexpr double power_of_ten(const std::uint8_t digits) noexcept {
    constexpr std::uint32_t most = 4U;
    const std::uint32_t count = (digits < most) ? digits : most;
    double power = 1.0;
    for (std::uint32_t digit = 0U; digit < count; ++digit) {
        power *= 10.0;
    }
    return power;
}

/// What an integer with decimal digits stands for: 1234 with two digits is 12.34. Equal values with different digits
/// give the same number, for the quotient is rounded once.
constexpr double physical_value(const std::int32_t integer, const std::uint8_t digits) noexcept {
    return static_cast<double>(integer) / power_of_ten(digits);
}

/// The 16-bit integer that stands for a value, the nearest (halves away from zero), held at the ends of the type.
inline std::int16_t process_value(const double value, const std::uint8_t digits) noexcept {
    const double nearest = std::round(value * power_of_ten(digits));
    constexpr double least = -32768.0;
    constexpr double greatest = 32767.0;
    return static_cast<std::int16_t>(std::fmin(std::fmax(nearest, least), greatest));
}

}  // namespace canproof
