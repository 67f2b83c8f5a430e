// SPDX-License-Identifier: Apache-2.0
// 64-bit fixed point numbers and polynomials: for computations that need more than single precision, on a processor
// whose FPU has no double precision.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::ax188001 {

/// A fixed-point number in units of 2^-40, within ±2^23.
using Fixed = std::int64_t;

constexpr std::uint32_t fixed_places = 40U;
constexpr double fixed_one = 1099511627776.0;  // 2^40

/// Converts a number whose magnitude is below 2^23; the part below one unit is truncated.
constexpr Fixed to_fixed(const double value) noexcept {
    return static_cast<Fixed>(value * fixed_one);
}

constexpr double from_fixed(const Fixed value) noexcept {
    constexpr double step = 1.0 / fixed_one;
    return static_cast<double>(value) * step;
}

/// Converts a difference from single precision, which is sufficient for a difference. Its magnitude is below 2^23.
constexpr Fixed to_fixed(const float value) noexcept {
    return static_cast<Fixed>(value * static_cast<float>(fixed_one));
}

constexpr float rough(const Fixed value) noexcept {
    constexpr float step = static_cast<float>(1.0 / fixed_one);
    return static_cast<float>(value) * step;
}

constexpr std::uint64_t magnitude(const Fixed value) noexcept {
    return static_cast<std::uint64_t>((value < 0) ? -value : value);
}

/// Returns the upper 64 bits of a product, at most 2 too small: the product of the lower halves is omitted.
constexpr std::uint64_t upper_product(const std::uint64_t a, const std::uint64_t b) noexcept {
    constexpr std::uint32_t half = 32U;
    constexpr std::uint64_t lower = 0xFFFFFFFFU;
    const std::uint64_t a_high = a >> half;
    const std::uint64_t b_high = b >> half;
    return (a_high * b_high) + ((a_high * (b & lower)) >> half) + (((a & lower) * b_high) >> half);
}

/// The distance of a number from a centre, as a fraction of 2^reach: the argument of a polynomial about that centre.
struct Offset {
    std::uint64_t fraction{0U};  ///< in units of 2^-64
    bool is_below{false};
};

/// The polynomial Σ a[i]·((x − centre) / 2^reach)ⁱ. Because the centre is the middle of the range, the terms do not
/// cancel, so that units of 2^-40 are sufficient for each sum. Beyond 2^reach from the centre the polynomial is
/// constant.
template <std::size_t Size>
struct FixedPolynomial {
    Fixed centre{0};
    std::uint32_t reach{0U};  ///< at most 23
    std::uint32_t terms{0U};  ///< number of coefficients used; those after them are zero
    std::array<Fixed, Size> coefficients{};

    constexpr Offset offset(const Fixed x) const noexcept {
        constexpr std::uint32_t spare_bits = 64U - fixed_places;
        const std::uint64_t distance = magnitude(x - centre);
        const bool is_within = (distance >> (fixed_places + reach)) == 0U;
        return Offset{is_within ? (distance << (spare_bits - reach)) : UINT64_MAX, x < centre};
    }

    /// Returns the value by Horner's scheme. Each sum has an error of at most 2^-38; the following multiplications by a
    /// fraction reduce this error.
    constexpr Fixed value(const Offset& at) const noexcept {
        Fixed sum{0};
        for (std::size_t i = terms; i > 0U; --i) {
            const auto product = static_cast<Fixed>(upper_product(magnitude(sum), at.fraction));
            sum = coefficients[i - 1U] + (((sum < 0) == at.is_below) ? product : -product);
        }
        return sum;
    }
    constexpr Fixed value(const Fixed x) const noexcept { return value(offset(x)); }
};

/// Returns Σ c[i]·xⁱ as a polynomial about the middle of `from`…`to`; the coefficients after `terms` are zero.
template <std::size_t Size>
constexpr FixedPolynomial<Size> fixed_polynomial(std::array<double, Size> c, const std::size_t terms, const double from,
                                                 const double to) noexcept {
    const double centre = (from + to) / 2.0;
    FixedPolynomial<Size> made{};
    double unit{1.0};
    while (unit <= (to - centre)) {
        unit *= 2.0;
        ++made.reach;
    }
    made.centre = to_fixed(centre);
    made.terms = static_cast<std::uint32_t>(terms);
    double scale{1.0};
    for (std::size_t i = 0U; i < terms; ++i) {
        for (std::size_t j = terms - 1U; j > i; --j) {
            c[j - 1U] += c[j] * centre;  // divides by (x − centre); the remainder is the next coefficient
        }
        made.coefficients[i] = to_fixed(c[i] * scale);
        scale *= unit;
    }
    return made;
}

}  // namespace canproof::ax188001
