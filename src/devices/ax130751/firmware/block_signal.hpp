// SPDX-License-Identifier: Apache-2.0
// The signals between the function blocks of the AX130751.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "devices/ax130751/firmware/decimal_quotient.hpp"
#include "devices/ax130751/firmware/quotient.hpp"
#include "firmware/base/bytes.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/blocks/bounds.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

enum class SignalState : std::uint8_t {
    valid,
    error,         ///< the source of the value has failed
    not_available  ///< no source is chosen, or the block that is the source is off
};

/// A value in its physical unit, with its limits (`lower` <= `upper`).
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

/// Returns ten to the power of `digits`, 0…4; greater numbers count as 4.
constexpr double power_of_ten(const std::uint8_t digits) noexcept {
    constexpr std::uint32_t most = 4U;
    return powers_of_ten[(digits < most) ? digits : most];
}

/// Returns the value of an integer with decimal digits: 1234 with two digits is 12.34. Equal values with different
/// digits give the same number, because the quotient is rounded once.
inline double physical_value(const std::int32_t integer, const std::uint8_t digits) noexcept {
    constexpr std::uint32_t most = 4U;
    return (digits == 0U) ? static_cast<double>(integer) : decimal_quotient(integer, (digits < most) ? digits : most);
}

/// Returns a check number, which changes when a single bit of `value` changes.
inline std::uint16_t check_of(const double value) noexcept {
    const auto bits = bit_cast<std::uint64_t>(value);
    const auto word = static_cast<std::uint32_t>(bits ^ (bits >> 32U));
    return static_cast<std::uint16_t>(word ^ (word >> 16U));
}

/// A physical value that is read often but rarely changes. This cache depends on the integer and the digits: the
/// value is computed again only when one of them changes, or when a bit of the cache has flipped in memory.
class KeptPhysicalValue {
  public:
    static_assert(implements<req::AOR_SRC_013>);
    double of(const std::int32_t integer, const std::uint8_t digits) noexcept {
        if ((integer != integer_) || (std::uint32_t{digits} != digits_) ||
            (std::uint32_t{check_} != check_of(value_))) {
            integer_ = integer;
            digits_ = digits;
            value_ = physical_value(integer, digits);
            check_ = check_of(value_);
        }
        return value_;
    }

  private:
    double value_{0.0};
    std::int32_t integer_{0};
    std::uint8_t digits_{0U};
    std::uint16_t check_{0U};  ///< check_of(value_), unless a bit of `value_` or `check_` has flipped in memory
};

/// A measured value in whole tenths; NaN gives 0. It is read often: each input of a block may have it as its source.
/// This cache depends on the bits of the measured value: the tenths are computed again only when they change, or when a
/// bit of the cache has flipped in memory. Their division takes as long as the rest of reading a source.
class KeptTenths {
  public:
    static_assert(implements<req::AOR_SRC_008> && implements<req::AOR_SRC_013>);
    double of(const float measured) noexcept {
        const auto bits = bit_cast<std::uint32_t>(measured);
        if ((bits != bits_) || (std::uint32_t{check_} != check_of(value_))) {
            bits_ = bits;
            value_ = std::isnan(measured) ? 0.0 : quotient(std::round(static_cast<double>(measured) * 10.0), 10.0);
            check_ = check_of(value_);
        }
        return value_;
    }

  private:
    double value_{0.0};
    std::uint32_t bits_{0U};
    std::uint16_t check_{0U};  ///< check_of(value_), unless a bit of `value_` or `check_` has flipped in memory
};

/// Returns the INTEGER16 for a value with `digits` decimal digits: rounded to nearest (halves away from zero) and
/// saturated. NaN gives -32768.
inline std::int16_t process_value(const double value, const std::uint8_t digits) noexcept {
    constexpr double far = 40000.0;  // beyond every INTEGER16; all numbers below it fit an INTEGER32
    const double scaled = (digits == 0U) ? value : (value * power_of_ten(digits));
    if (std::fabs(scaled) < far) {
        const auto rounded = static_cast<std::int32_t>(std::lround(scaled));
        return static_cast<std::int16_t>(std::clamp(rounded, std::int32_t{INT16_MIN}, std::int32_t{INT16_MAX}));
    }
    return (scaled > 0.0) ? INT16_MAX : INT16_MIN;
}

}  // namespace canproof::ax130751
