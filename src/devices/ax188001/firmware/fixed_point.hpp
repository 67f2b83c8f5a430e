// Fixed point of 64 bits, and polynomials in it: for what single precision does not carry, on a processor whose FPU
// has nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::ax188001 {

/// A number in steps of 2^-40, within ±2^23.
using Fixed = std::int64_t;

constexpr std::uint32_t fixed_places = 40U;
constexpr double fixed_one = 1099511627776.0;  // 2^40

/// What is less than a step is left out.
constexpr Fixed to_fixed(const double value) noexcept {
    return static_cast<Fixed>(value * fixed_one);
}

constexpr double from_fixed(const Fixed value) noexcept {
    constexpr double step = 1.0 / fixed_one;
    return static_cast<double>(value) * step;
}

/// For differences, of which single precision is enough.
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

/// The upper 64 bits of a product, at most 2 too small: the product of the lower halves is left out.
constexpr std::uint64_t upper_product(const std::uint64_t a, const std::uint64_t b) noexcept {
    constexpr std::uint32_t half = 32U;
    constexpr std::uint64_t lower = 0xFFFFFFFFU;
    const std::uint64_t a_high = a >> half;
    const std::uint64_t b_high = b >> half;
    return (a_high * b_high) + ((a_high * (b & lower)) >> half) + (((a & lower) * b_high) >> half);
}

/// How far a number lies from a centre, as a fraction of 2^reach: what a polynomial about that centre is taken at.
struct Offset {
    std::uint64_t fraction{0U};  ///< in steps of 2^-64
    bool is_below{false};
};

/// Σ a[i]·((x − centre) / 2^reach)ⁱ. About the middle of its range nothing of a polynomial cancels, so that steps of
/// 2^-40 are enough for each of its sums. Further than 2^reach from the centre it stays what it is there.
template <std::size_t Size>
struct FixedPolynomial {
    Fixed centre{0};
    std::uint32_t reach{0U};  ///< at most 23
    std::uint32_t terms{0U};  ///< coefficients behind these are zero
    std::array<Fixed, Size> coefficients{};

    constexpr Offset offset(const Fixed x) const noexcept {
        constexpr std::uint32_t spare_bits = 64U - fixed_places;
        const std::uint64_t distance = magnitude(x - centre);
        const bool is_within = (distance >> (fixed_places + reach)) == 0U;
        return Offset{is_within ? (distance << (spare_bits - reach)) : UINT64_MAX, x < centre};
    }

    /// Horner's scheme. Each sum is right to 2^-38, times what is left of it at the end.
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

/// Σ c[i]·xⁱ, whose coefficients behind `terms` are zero, about the middle of `from`…`to`.
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
            c[j - 1U] += c[j] * centre;  // divides by (x − centre): the remainder is the next coefficient
        }
        made.coefficients[i] = to_fixed(c[i] * scale);
        scale *= unit;
    }
    return made;
}

}  // namespace canproof::ax188001
