// What one function block hands to another.
#pragma once

#include <array>
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
    constexpr std::array<double, 5U> powers{{1.0, 10.0, 100.0, 1000.0, 10000.0}};
    constexpr std::uint32_t most = 4U;
    return powers[(digits < most) ? digits : most];
}

/// What an integer with decimal digits stands for: 1234 with two digits is 12.34. Equal values with different digits
/// give the same number, for the quotient is rounded once.
constexpr double physical_value(const std::int32_t integer, const std::uint8_t digits) noexcept {
    const double whole = static_cast<double>(integer);
    return (digits == 0U) ? whole : (whole / power_of_ten(digits));  // the FPU of a Cortex-M4F divides no doubles
}

/// The smaller of two numbers; the second when the first is none. One comparison, where std::fmin sorts out every NaN.
constexpr double lesser(const double a, const double b) noexcept {
    return (a < b) ? a : b;
}
/// The greater of two numbers; the second when the first is none.
constexpr double greater(const double a, const double b) noexcept {
    return (a > b) ? a : b;
}

/// The 16-bit integer that stands for a value, the nearest (halves away from zero), held at the ends of the type.
inline std::int16_t process_value(const double value, const std::uint8_t digits) noexcept {
    constexpr double least = -32768.0;
    constexpr double most = 32767.0;
    const double scaled = (digits == 0U) ? value : (value * power_of_ten(digits));
    return static_cast<std::int16_t>(std::round(lesser(greater(scaled, least), most)));
}

}  // namespace canproof
