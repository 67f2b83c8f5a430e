// What one function block hands to another.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "firmware/blocks/bounds.hpp"

namespace canproof::ax130751 {

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

inline constexpr std::array<double, 5U> powers_of_ten{{1.0, 10.0, 100.0, 1000.0, 10000.0}};

/// Ten to the number of decimal digits, 0…4; more count as 4.
constexpr double power_of_ten(const std::uint8_t digits) noexcept {
    constexpr std::uint32_t most = 4U;
    return powers_of_ten[(digits < most) ? digits : most];
}

/// What an integer with decimal digits stands for: 1234 with two digits is 12.34. Equal values with different digits
/// give the same number, for the quotient is rounded once.
constexpr double physical_value(const std::int32_t integer, const std::uint8_t digits) noexcept {
    const double whole = static_cast<double>(integer);
    return (digits == 0U) ? whole : (whole / power_of_ten(digits));  // the FPU of a Cortex-M4F divides no doubles
}

/// A physical value that is asked for again and again, and rarely with another integer or other digits: then only it is
/// divided. Keys of this cache: the integer and its digits.
class KeptPhysicalValue {
  public:
    constexpr double of(const std::int32_t integer, const std::uint8_t digits) noexcept {
        if ((integer != integer_) || (std::uint32_t{digits} != digits_)) {
            integer_ = integer;
            digits_ = digits;
            value_ = physical_value(integer, digits);
        }
        return value_;
    }

  private:
    double value_{0.0};
    std::int32_t integer_{0};
    std::uint8_t digits_{0U};
};

/// The 16-bit integer that stands for a value, the nearest (halves away from zero), held at the ends of the type.
inline std::int16_t process_value(const double value, const std::uint8_t digits) noexcept {
    constexpr double least = -32768.0;
    constexpr double most = 32767.0;
    const double scaled = (digits == 0U) ? value : (value * power_of_ten(digits));
    return static_cast<std::int16_t>(std::round(lesser(greater(scaled, least), most)));
}

}  // namespace canproof::ax130751
