// SPDX-License-Identifier: Apache-2.0
// Divides an integer by a power of ten. The FPU of a Cortex-M4F cannot divide doubles, and the division of the library
// takes about 750 instructions.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/base/bytes.hpp"

namespace canproof::ax130751 {

/// Returns integer / 10^digits for `digits` 1…4, rounded once to the nearest double (halves to even): the same number
/// as the division of two doubles. Divides in base 2^18 (2^17 for one digit), which gives at least 54 bits of the
/// quotient, then appends a 1 for the remainder. The conversion to double rounds to 53 bits. Without a remainder, the
/// quotient has at most 32 bits that count, and the 1 at its end does not change the rounded number.
inline double decimal_quotient(const std::int32_t integer, const std::uint32_t digits) noexcept {
    struct Divisor {
        std::uint32_t power;  ///< 10^digits
        std::uint32_t step;   ///< bits of a step: power * 2^step fits 32 bits, and the quotient 63 bits
    };
    constexpr std::array<Divisor, 5U> divisors{{{1U, 0U}, {10U, 17U}, {100U, 18U}, {1000U, 18U}, {10000U, 18U}}};
    constexpr std::array<std::uint32_t, 5U> shifts{{16U, 8U, 4U, 2U, 1U}};
    constexpr std::uint32_t word_size{32U};
    constexpr std::uint32_t exponent_place{52U};
    if (integer == 0) {
        return 0.0;
    }
    const Divisor divisor = divisors[digits];
    const bool negative = integer < 0;
    const std::int64_t wide = integer;
    std::uint32_t rest = static_cast<std::uint32_t>(negative ? -wide : wide);
    std::uint32_t places{0U};  // the number of bits by which the quotient is shifted to the left
    for (const std::uint32_t shift : shifts) {
        if ((rest >> (word_size - shift)) == 0U) {
            rest <<= shift;
            places += shift;
        }
    }
    std::uint64_t found = rest / divisor.power;
    for (std::uint32_t step = 0U; step < 2U; ++step) {
        rest = (rest % divisor.power) << divisor.step;
        found = (found << divisor.step) + (rest / divisor.power);
        places += divisor.step;
    }
    const auto rounded = static_cast<double>((found << 1U) | 1U);
    const std::uint64_t exponent = std::uint64_t{places} + 1U;
    const auto value = bit_cast<double>(bit_cast<std::uint64_t>(rounded) - (exponent << exponent_place));
    return negative ? -value : value;
}

}  // namespace canproof::ax130751
