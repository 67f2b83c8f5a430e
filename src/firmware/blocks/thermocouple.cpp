#include "firmware/blocks/thermocouple.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax188001/requirements.hpp"

namespace canproof {

namespace {

// Newton's method doubles the digits with each step; halving the interval instead gains at least one bit a step, and
// 64 of them bring 2100 °C below 1e-15 °C. Seven are the most that any voltage of the eight types takes.
constexpr std::size_t most_steps = 64U;
constexpr double close_enough_c = 1e-7;

/// Horner's scheme.
template <std::size_t Size>
double polynomial(const std::array<double, Size>& coefficients, const double x) noexcept {
    double sum{0.0};
    for (std::size_t i = Size; i > 0U; --i) {
        sum = (sum * x) + coefficients[i - 1U];
    }
    return sum;
}

template <std::size_t Size>
double derivative(const std::array<double, Size>& coefficients, const double x) noexcept {
    double sum{0.0};
    for (std::size_t i = Size; i > 1U; --i) {
        sum = (sum * x) + (coefficients[i - 1U] * static_cast<double>(i - 1U));
    }
    return sum;
}

double exponential_mv(const ExponentialTerm& term, const double celsius) noexcept {
    const double distance = celsius - term.a2_c;
    return term.a0_mv * decay(term.a1_per_c2 * distance * distance);
}

const ReferencePiece& reference_piece(const ThermocoupleCurve& curve, const double celsius) noexcept {
    std::size_t at{0U};
    while (((at + 1U) < curve.reference_count) && (celsius >= curve.reference[at].to_c)) {
        ++at;
    }
    return curve.reference[at];
}

double clamped(const double value, const double low, const double high) noexcept {
    return std::fmin(std::fmax(value, low), high);
}

}  // namespace

static_assert(implements<req::TCS_CONV_008>);
double decay(const double x) noexcept {
    constexpr double negligible = -40.0;  // e^-40 is 4e-18
    if (x < negligible) {
        return 0.0;
    }
    // (e^(x/64))^64: with |x/64| up to 0.625 the series of degree 13 errs by 0.625^14 / 14! = 1.6e-14, times 64.
    constexpr double parts = 64.0;
    constexpr std::size_t squarings = 6U;
    constexpr std::size_t degree = 13U;
    const double y = x / parts;
    double sum{1.0};
    for (std::size_t n = degree; n > 0U; --n) {
        sum = 1.0 + ((y / static_cast<double>(n)) * sum);
    }
    for (std::size_t i = 0U; i < squarings; ++i) {
        sum *= sum;
    }
    return sum;
}

static_assert(implements<req::TCS_CONV_005> && implements<req::TCS_CONV_010>);
double reference_mv(const ThermocoupleCurve& curve, const double celsius) noexcept {
    const ReferencePiece& piece = reference_piece(curve, celsius);
    return polynomial(piece.coefficients, celsius) + exponential_mv(piece.exponential, celsius);
}

double reference_slope(const ThermocoupleCurve& curve, const double celsius) noexcept {
    const ReferencePiece& piece = reference_piece(curve, celsius);
    const ExponentialTerm& term = piece.exponential;
    const double inner_slope = 2.0 * term.a1_per_c2 * (celsius - term.a2_c);
    return derivative(piece.coefficients, celsius) + (inner_slope * exponential_mv(term, celsius));
}

static_assert(implements<req::TCS_CONV_009>);
double approximate_celsius(const ThermocoupleCurve& curve, const double mv) noexcept {
    std::size_t at{0U};
    while (((at + 1U) < curve.inverse_count) && (mv > curve.inverse[at].to_mv)) {
        ++at;
    }
    const InversePiece& piece = curve.inverse[at];
    return polynomial(piece.coefficients, clamped(mv, piece.from_mv, piece.to_mv));
}

static_assert(implements<req::TCS_CONV_002> && implements<req::TCS_CONV_003> && implements<req::TCS_CONV_004>);
double exact_celsius(const ThermocoupleCurve& curve, const double mv) noexcept {
    double low = curve.lowest_c;
    double high = curve.highest_c;
    if (mv <= reference_mv(curve, low)) {
        return low;
    }
    if (mv >= reference_mv(curve, high)) {
        return high;
    }
    double guess = clamped(approximate_celsius(curve, mv), low, high);
    for (std::size_t step = 0U; step < most_steps; ++step) {
        const double excess = reference_mv(curve, guess) - mv;
        if (excess > 0.0) {
            high = guess;
        } else {
            low = guess;
        }
        double next = guess - (excess / reference_slope(curve, guess));
        const bool inside = (next >= low) && (next <= high);  // false for a NaN, too
        if (!inside) {
            next = (low + high) / 2.0;
        }
        const double moved = std::fabs(next - guess);
        guess = next;
        if (moved < close_enough_c) {
            break;
        }
    }
    return guess;
}

}  // namespace canproof
