#include "firmware/blocks/thermocouple.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax188001/requirements.hpp"

namespace canproof {

namespace {

// Newton's method doubles the digits with each step; halving the interval instead gains at least one bit a step, and
// 64 of them bring 2100 °C below 1e-15 °C.
constexpr std::size_t most_steps = 64U;
// Within so little the slope stays what it is to 1 in 200 (type B at 42 °C, where it turns most; elsewhere to 1 in
// 10,000): a shorter step takes that of the step before, and leaves at most a two hundredth of itself.
constexpr double same_slope_c = 0.1;
constexpr double close_enough_c = 1e-5;

/// Horner's scheme.
template <typename Piece>
double polynomial(const Piece& piece, const double x) noexcept {
    double sum{0.0};
    for (std::size_t i = piece.terms; i > 0U; --i) {
        sum = (sum * x) + piece.coefficients[i - 1U];
    }
    return sum;
}

double derivative(const ReferencePiece& piece, const double x) noexcept {
    double sum{0.0};
    for (std::size_t i = piece.terms; i > 1U; --i) {
        sum = (sum * x) + (piece.coefficients[i - 1U] * static_cast<double>(i - 1U));
    }
    return sum;
}

/// In single precision, which the FPU of a Cortex-M4F has: it only steers. Without the exponential term, which bends
/// the curve little.
float rough_curvature(const ReferencePiece& piece, const double x) noexcept {
    const float at = static_cast<float>(x);
    float sum{0.0F};
    for (std::size_t i = piece.terms; i > 2U; --i) {
        const float factor = static_cast<float>(i - 1U) * static_cast<float>(i - 2U);
        sum = (sum * at) + (static_cast<float>(piece.coefficients[i - 1U]) * factor);
    }
    return sum;
}

/// How far it is to where a parabola of this excess, slope and curvature is zero; by the slope alone where there is no
/// such place, and far outside of every thermocouple's voltages. Beside a minimum (types K, N, T and E at -270 °C, B at
/// 21 °C) the slope alone would lead half of the way each time.
double way_to_root(const double excess, const double slope, const float curvature) noexcept {
    constexpr double most_excess_mv = 1000.0;
    float inner{0.0F};
    if (std::fabs(excess) < most_excess_mv) {
        const float rise = static_cast<float>(slope);
        inner = (rise * rise) - (2.0F * curvature * static_cast<float>(excess));
    }
    const double both = (inner > 0.0F) ? (slope + static_cast<double>(std::sqrt(inner))) : (2.0 * slope);
    return (-2.0 * excess) / both;
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
    constexpr std::array<double, degree> reciprocals{{1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0, 1.0 / 6.0,
                                                      1.0 / 7.0, 1.0 / 8.0, 1.0 / 9.0, 1.0 / 10.0, 1.0 / 11.0,
                                                      1.0 / 12.0, 1.0 / 13.0}};
    const double y = x / parts;
    double sum{1.0};
    for (std::size_t n = degree; n > 0U; --n) {
        sum = 1.0 + ((y * reciprocals[n - 1U]) * sum);
    }
    for (std::size_t i = 0U; i < squarings; ++i) {
        sum *= sum;
    }
    return sum;
}

static_assert(implements<req::TCS_CONV_005> && implements<req::TCS_CONV_010>);
double reference_mv(const ThermocoupleCurve& curve, const double celsius) noexcept {
    const ReferencePiece& piece = reference_piece(curve, celsius);
    return polynomial(piece, celsius) + exponential_mv(piece.exponential, celsius);
}

double reference_slope(const ThermocoupleCurve& curve, const double celsius) noexcept {
    const ReferencePiece& piece = reference_piece(curve, celsius);
    const ExponentialTerm& term = piece.exponential;
    const double inner_slope = 2.0 * term.a1_per_c2 * (celsius - term.a2_c);
    return derivative(piece, celsius) + (inner_slope * exponential_mv(term, celsius));
}

static_assert(implements<req::TCS_CONV_009>);
double approximate_celsius(const ThermocoupleCurve& curve, const double mv) noexcept {
    std::size_t at{0U};
    while (((at + 1U) < curve.inverse_count) && (mv > curve.inverse[at].to_mv)) {
        ++at;
    }
    const InversePiece& piece = curve.inverse[at];
    return polynomial(piece, clamped(mv, piece.from_mv, piece.to_mv));
}

static_assert(implements<req::TCS_CONV_002> && implements<req::TCS_CONV_003> && implements<req::TCS_CONV_004>);
double exact_celsius(const ThermocoupleCurve& curve, const double mv) noexcept {
    double low = curve.lowest_c;
    double high = curve.highest_c;
    bool low_is_end{true};
    bool high_is_end{true};
    double guess = clamped(approximate_celsius(curve, mv), low, high);
    double moved = high - low;
    double slope{0.0};
    float curvature{0.0F};
    for (std::size_t step = 0U; (step < most_steps) && !(moved < close_enough_c); ++step) {
        const double excess = reference_mv(curve, guess) - mv;
        if (excess > 0.0) {
            high = guess;
            high_is_end = false;
        } else {
            low = guess;
            low_is_end = false;
        }
        if (!(moved < same_slope_c)) {
            slope = reference_slope(curve, guess);
            curvature = rough_curvature(reference_piece(curve, guess), guess);
        }
        double next = guess + way_to_root(excess, slope, curvature);
        const bool inside = (next >= low) && (next <= high);  // false for a NaN, too
        if (!inside) {
            if (low_is_end && (mv <= reference_mv(curve, low))) {
                return low;
            }
            if (high_is_end && (mv >= reference_mv(curve, high))) {
                return high;
            }
            next = (low + high) / 2.0;
        }
        moved = inside ? std::fabs(next - guess) : (high - low);
        guess = next;
    }
    return guess;
}

}  // namespace canproof
