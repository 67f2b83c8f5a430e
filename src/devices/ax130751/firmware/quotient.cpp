// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/quotient.hpp"

#include <cstdint>

#include "firmware/base/bytes.hpp"

namespace canproof::ax130751 {

namespace {

constexpr std::uint32_t fraction_bits{52U};
constexpr std::uint64_t hidden_bit = std::uint64_t{1U} << fraction_bits;
constexpr std::uint64_t sign_bit = std::uint64_t{1U} << 63U;

/// Returns the exponent of a double, with its bias; 0 for zero and subnormal numbers, 2047 for infinity and NaN.
constexpr std::uint32_t exponent_of(const std::uint64_t bits) noexcept {
    return static_cast<std::uint32_t>(bits >> fraction_bits) & 0x7FFU;
}

/// Returns the digits of a double, with the hidden bit in front of them.
constexpr std::uint64_t digits_of(const std::uint64_t bits) noexcept {
    return (bits & (hidden_bit - 1U)) | hidden_bit;
}

/// Returns the 53 digits of the quotient, rounded; `dividend` is at least `divisor` and less than twice as large.
/// Divides in base 2^11, so that the rest times the base fits into 64 bits. The divisor has 21 bits in its upper word.
/// With this word plus 1, a digit is estimated right or 1 too low. The quotient never lies in the middle of two
/// doubles, because its product with the divisor would then have more than 53 bits.
constexpr std::uint64_t divide(const std::uint64_t dividend, const std::uint64_t divisor) noexcept {
    constexpr std::uint32_t base_bits{11U};
    constexpr std::uint32_t word_bits{32U};
    constexpr std::uint32_t steps{5U};
    const std::uint32_t upper = static_cast<std::uint32_t>(divisor >> word_bits) + 1U;
    std::uint64_t rest = dividend - divisor;
    std::uint64_t found{1U};
    for (std::uint32_t step = 0U; step < steps; ++step) {
        const std::uint32_t digit = static_cast<std::uint32_t>(rest >> (word_bits - base_bits)) / upper;
        rest = (rest << base_bits) - (divisor * digit);
        found = (found << base_bits) + digit;
        if (rest >= divisor) {
            rest -= divisor;
            ++found;
        }
    }
    constexpr std::uint32_t further_bits = (base_bits * steps) - fraction_bits;
    return (found + (std::uint64_t{1U} << (further_bits - 1U))) >> further_bits;
}

}  // namespace

double quotient(const double dividend, const double divisor) noexcept {
    constexpr std::uint32_t bias{1023U};
    constexpr std::uint32_t greatest{2047U};
    const auto above = bit_cast<std::uint64_t>(dividend);
    const auto below = bit_cast<std::uint64_t>(divisor);
    const std::uint64_t sign = (above ^ below) & sign_bit;
    const std::uint32_t of_above = exponent_of(above);
    const std::uint32_t of_below = exponent_of(below);
    if (of_above == greatest) {
        // An infinite dividend, or NaN, stays what it is, but the sign of the divisor counts.
        return bit_cast<double>(above ^ (below & sign_bit));
    }
    if (of_below == greatest) {
        const bool is_infinite = (below & (hidden_bit - 1U)) == 0U;
        return bit_cast<double>(is_infinite ? sign : below);
    }
    const std::uint32_t shifted = of_above + bias;  // the exponent of the quotient plus that of the divisor
    if ((of_above == 0U) || (shifted <= (of_below + 1U))) {
        return bit_cast<double>(sign);
    }
    if ((of_below == 0U) || (shifted >= (of_below + greatest))) {
        return bit_cast<double>(sign | (std::uint64_t{greatest} << fraction_bits));
    }
    const std::uint64_t divisor_digits = digits_of(below);
    const std::uint64_t digits = digits_of(above);
    const bool is_less = digits < divisor_digits;
    const std::uint64_t found = divide(is_less ? (digits << 1U) : digits, divisor_digits);
    // The hidden bit of the digits adds 1 to the exponent.
    const std::uint64_t exponent{shifted - of_below - (is_less ? 2U : 1U)};
    return bit_cast<double>(sign + (exponent << fraction_bits) + found);
}

}  // namespace canproof::ax130751
