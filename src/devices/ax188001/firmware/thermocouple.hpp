// SPDX-License-Identifier: Apache-2.0
// Thermocouples: converts temperature to voltage and back by the reference and inverse functions of the ITS-90
// (AX188001, 1.1). It uses fixed point: single precision is too coarse for polynomials of degree 14, and double
// precision is slow without an FPU for it. Slopes are in single precision, because they only steer the search. All
// library functions called are exact or correctly rounded.
#pragma once

#include <array>
#include <cstddef>

#include "devices/ax188001/firmware/fixed_point.hpp"

namespace canproof::ax188001 {

/// The exponential term a0·exp(a1·(t − a2)²) with negative a1; type K only. Computed as a power of two:
/// a0·2^−whole·2^−rest.
struct ExponentialTerm {
    static constexpr std::size_t powers = 12U;  ///< terms of the series of 2^−rest, whose error is then 7e-15
    Fixed centre{0};
    std::uint64_t halvings{0U};  ///< number of times the term halves within 1024 °C of its centre, times 2^56
    float bend{0.0F};            ///< 2·a1
    FixedPolynomial<powers> mv_of_rest{};
};

/// A piece of the reference function: Σ c[i]·tⁱ in mV with the reference junction at 0 °C, for t from `begin` to `end`.
struct ReferencePiece {
    static constexpr std::size_t size = 15U;
    Fixed begin{0};  ///< °C
    Fixed end{0};    ///< °C
    FixedPolynomial<size> mv{};
    std::array<float, size> slope{};  ///< coefficients of the slope in mV/°C, for the same argument as `mv`
    const ExponentialTerm* exponential{nullptr};
};

/// A piece of the inverse function: Σ d[i]·Eⁱ in °C, approximate, for E from `begin` to `end`.
struct InversePiece {
    static constexpr std::size_t size = 11U;
    Fixed begin{0};  ///< mV
    Fixed end{0};    ///< mV
    FixedPolynomial<size> celsius{};
};

/// Returns the number of coefficients up to the last one that is not zero.
template <std::size_t Size>
constexpr std::size_t terms_of(const std::array<double, Size>& coefficients) noexcept {
    std::size_t terms{Size};
    while ((terms > 0U) && (coefficients[terms - 1U] <= 0.0) && (coefficients[terms - 1U] >= 0.0)) {
        --terms;
    }
    return terms;
}

constexpr ReferencePiece reference_piece(const double from_c, const double to_c,
                                         const std::array<double, ReferencePiece::size>& coefficients) noexcept {
    ReferencePiece piece{};
    piece.begin = to_fixed(from_c);
    piece.end = to_fixed(to_c);
    piece.mv = fixed_polynomial(coefficients, terms_of(coefficients), from_c, to_c);
    const auto unit_c = static_cast<double>(std::uint32_t{1U} << piece.mv.reach);
    for (std::size_t i = 1U; i < piece.mv.terms; ++i) {
        piece.slope[i - 1U] =
            static_cast<float>(from_fixed(piece.mv.coefficients[i]) * static_cast<double>(i) / unit_c);
    }
    return piece;
}

constexpr InversePiece inverse_piece(const double from_mv, const double to_mv,
                                     const std::array<double, InversePiece::size>& coefficients) noexcept {
    return InversePiece{to_fixed(from_mv), to_fixed(to_mv),
                        fixed_polynomial(coefficients, terms_of(coefficients), from_mv, to_mv)};
}

/// Makes the exponential term from the parameters of the ITS-90.
constexpr ExponentialTerm exponential_term(const double a0_mv, const double a1_per_c2, const double a2_c) noexcept {
    constexpr double natural_logarithm_of_2 = 0.69314718055994530942;
    constexpr double root_of_2 = 1.41421356237309504880;
    constexpr double farthest = 1048576.0;  // 1024 °C, squared
    constexpr double most = 256.0;
    constexpr double steps = 18446744073709551616.0;  // 2^64
    const double halvings = -a1_per_c2 * farthest / (natural_logarithm_of_2 * most);
    ExponentialTerm term{};
    term.centre = to_fixed(a2_c);
    term.halvings = (halvings < 1.0) ? static_cast<std::uint64_t>(halvings * steps) : UINT64_MAX;
    term.bend = static_cast<float>(2.0 * a1_per_c2);
    term.mv_of_rest.centre = to_fixed(0.5);
    term.mv_of_rest.terms = ExponentialTerm::powers;
    double coefficient = a0_mv / root_of_2;  // series of 2^-rest about rest = 1/2: (-ln 2)^i / i!
    for (std::size_t i = 0U; i < ExponentialTerm::powers; ++i) {
        term.mv_of_rest.coefficients[i] = to_fixed(coefficient);
        coefficient *= -natural_logarithm_of_2 / static_cast<double>(i + 1U);
    }
    return term;
}

/// The curve of one type of thermocouple. The pieces ascend; each begins inside the previous piece or at its end.
struct ThermocoupleCurve {
    static constexpr std::size_t most_reference_pieces = 3U;
    static constexpr std::size_t most_inverse_pieces = 4U;
    std::array<ReferencePiece, most_reference_pieces> reference{};
    std::size_t reference_count{0U};
    std::array<InversePiece, most_inverse_pieces> inverse{};
    std::size_t inverse_count{0U};
    Fixed lowest{0};   ///< °C; from here to `highest` the voltage increases with the temperature
    Fixed highest{0};  ///< °C

    constexpr double lowest_c() const noexcept { return from_fixed(lowest); }
    constexpr double highest_c() const noexcept { return from_fixed(highest); }
};

/// Returns the voltage in mV at `celsius` with the reference junction at 0 °C, accurate to 1e-10 mV. Beyond the type's
/// range the nearest piece of the function is continued, to at most twice the length of this piece.
double reference_mv(const ThermocoupleCurve& curve, double celsius) noexcept;

/// Returns the slope of reference_mv in mV/°C, in single precision.
double reference_slope(const ThermocoupleCurve& curve, double celsius) noexcept;

/// Returns the temperature in °C by the inverse function, with an error of at most 0.06 °C within the function's range.
/// Beyond this range, returns the value at its end.
double approximate_celsius(const ThermocoupleCurve& curve, double mv) noexcept;

/// Returns the temperature in °C, from `lowest` to `highest`, at which reference_mv returns `mv`, exact to 1e-6 °C; for
/// type B only from 21.3 °C up, nearer to its minimum exact to 0.001 °C. A voltage beyond that range gives the end of
/// the range.
double exact_celsius(const ThermocoupleCurve& curve, double mv) noexcept;

/// Returns the exponential term in mV at `celsius`, accurate to 1e-11 mV.
double exponential_mv(const ExponentialTerm& term, double celsius) noexcept;

}  // namespace canproof::ax188001
