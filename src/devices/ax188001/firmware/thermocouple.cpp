// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/firmware/thermocouple.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "firmware/blocks/bounds.hpp"
#include "generated/ax188001/requirements.hpp"

namespace canproof::ax188001 {

namespace {

// Each step inside the interval at least doubles the number of correct digits. Two steps are usual. Types K, N, T and E
// below -200 °C and type B below 250 °C take three or four; the fourth moves by less than 1e-7 °C. Only within 0.016 °C
// of its minimum does type B not always end then: there the voltage has too few digits, and further steps would not
// make the result better. The limit bounds the time of a conversion.
constexpr std::size_t most_steps = 4U;
/// A short step of the search, in °C. After such a step, the error is below a thousandth of the step: slopes in single
/// precision are accurate enough for that.
constexpr Fixed close_enough = to_fixed(1e-5);

/// The value and the derivatives of a curve at a temperature.
struct CurvePoint {
    Fixed mv{0};
    float slope{0.0F};      ///< mV/°C
    float curvature{0.0F};  ///< mV/°C², without the exponential term, whose curvature is small
};

const ReferencePiece& reference_piece_at(const ThermocoupleCurve& curve, const Fixed celsius) noexcept {
    std::size_t at{0U};
    while (((at + 1U) < curve.reference_count) && (celsius >= curve.reference[at].end)) {
        ++at;
    }
    return curve.reference[at];
}

static_assert(implements<req::TCS_CONV_008>);
Fixed exponential(const ExponentialTerm& term, const Fixed celsius) noexcept {
    constexpr std::uint32_t reach = 10U;  // 1024 °C
    constexpr std::uint32_t whole_place = 56U;
    constexpr std::uint64_t whole_unit = std::uint64_t{1U} << whole_place;
    constexpr std::uint32_t negligible = 40U;  // after this many halvings the term is smaller than 2^-40 mV
    const std::uint64_t distance = magnitude(celsius - term.centre);
    if ((distance >> (fixed_places + reach)) != 0U) {
        return 0;
    }
    const std::uint64_t fraction = distance << (64U - fixed_places - reach);
    const std::uint64_t halvings = upper_product(upper_product(fraction, fraction), term.halvings);
    const std::uint64_t whole = halvings >> whole_place;
    const auto rest = static_cast<Fixed>((halvings & (whole_unit - 1U)) >> (whole_place - fixed_places));
    return (whole < negligible) ? static_cast<Fixed>(magnitude(term.mv_of_rest.value(rest)) >> whole) : 0;
}

/// Computes the slope and the curvature by Horner's scheme.
CurvePoint slopes_at(const ReferencePiece& piece, const Offset& at) noexcept {
    constexpr std::uint32_t single_places = 32U;
    constexpr float step = 1.0F / 4294967296.0F;  // 2^-32
    const float distance = static_cast<float>(static_cast<std::uint32_t>(at.fraction >> single_places)) * step;
    const float x = at.is_below ? -distance : distance;
    CurvePoint point{};
    for (std::size_t i = piece.mv.terms; i > 0U; --i) {
        point.curvature = (point.curvature * x) + point.slope;
        point.slope = (point.slope * x) + piece.slope[i - 1U];
    }
    point.curvature /= static_cast<float>(std::uint32_t{1U} << piece.mv.reach);
    return point;
}

static_assert(implements<req::TCS_CONV_005> && implements<req::TCS_CONV_010>);
CurvePoint curve_at(const ThermocoupleCurve& curve, const Fixed celsius) noexcept {
    const ReferencePiece& piece = reference_piece_at(curve, celsius);
    const Offset at = piece.mv.offset(celsius);
    CurvePoint point = slopes_at(piece, at);
    point.mv = piece.mv.value(at);
    if (piece.exponential != nullptr) {
        const Fixed added = exponential(*piece.exponential, celsius);
        point.mv += added;
        point.slope += piece.exponential->bend * rough(celsius - piece.exponential->centre) * rough(added);
    }
    return point;
}

Fixed mv_at(const ThermocoupleCurve& curve, const Fixed celsius) noexcept {
    return curve_at(curve, celsius).mv;
}

/// Returns the distance from `point` to the root of the parabola through it; `point` lies `excess` above the wanted
/// value. Uses only the slope if the parabola has no root. Near a minimum (types K, N, T and E at -270 °C, B at 21 °C)
/// the slope alone would cover half of the distance per step.
float way_to_root(const float excess, const CurvePoint& point) noexcept {
    const float inner = (point.slope * point.slope) - (2.0F * point.curvature * excess);
    const float both = (inner > 0.0F) ? (point.slope + std::sqrt(inner)) : (2.0F * point.slope);
    return (-2.0F * excess) / both;
}

/// Converts any double to fixed point. Values far outside the voltages and temperatures of every thermocouple are
/// clamped.
Fixed held(const double value) noexcept {
    constexpr double most = 4.0e6;
    return to_fixed(lesser(greater(value, -most), most));
}

Fixed clamped(const Fixed value, const Fixed low, const Fixed high) noexcept {
    const Fixed raised = (value < low) ? low : value;
    return (raised > high) ? high : raised;
}

/// Returns the temperature that the inverse function gives for `mv`. The search for the exact temperature starts there.
Fixed first_guess(const ThermocoupleCurve& curve, const Fixed mv) noexcept {
    std::size_t at{0U};
    while (((at + 1U) < curve.inverse_count) && (mv > curve.inverse[at].end)) {
        ++at;
    }
    const InversePiece& piece = curve.inverse[at];
    return piece.celsius.value(clamped(mv, piece.begin, piece.end));
}

/// Returns the temperature at which the search begins: that of the inverse function, or the lower end of the type's
/// range for a voltage below the range of the inverse function. Near this end the curve is almost a parabola, so the
/// next step leads close to the root.
Fixed start_of_search(const ThermocoupleCurve& curve, const Fixed mv) noexcept {
    if (mv < curve.inverse[0].begin) {
        return curve.lowest;
    }
    return clamped(first_guess(curve, mv), curve.lowest, curve.highest);
}

/// The interval that contains a root. A high end that is still the end of the type's range may itself be the result.
struct Bracket {
    Fixed low{0};
    Fixed high{0};
    bool high_is_end{true};

    /// Returns where the search goes on when a step leads out of the interval: to the high end of the type's range,
    /// otherwise to the middle.
    Fixed inner() const noexcept { return high_is_end ? high : (low + ((high - low) / 2)); }
};

}  // namespace

double exponential_mv(const ExponentialTerm& term, const double celsius) noexcept {
    return from_fixed(exponential(term, held(celsius)));
}

static_assert(implements<req::TCS_CJ_005>);
double reference_mv(const ThermocoupleCurve& curve, const double celsius) noexcept {
    return from_fixed(mv_at(curve, held(celsius)));
}

double reference_slope(const ThermocoupleCurve& curve, const double celsius) noexcept {
    return static_cast<double>(curve_at(curve, held(celsius)).slope);
}

static_assert(implements<req::TCS_CONV_009>);
double approximate_celsius(const ThermocoupleCurve& curve, const double mv) noexcept {
    return from_fixed(first_guess(curve, held(mv)));
}

static_assert(implements<req::TCS_CONV_002> && implements<req::TCS_CONV_003> && implements<req::TCS_CONV_004>);
double exact_celsius(const ThermocoupleCurve& curve, const double mv) noexcept {
    const Fixed wanted = held(mv);
    Bracket bracket{curve.lowest, curve.highest, true};
    Fixed guess = start_of_search(curve, wanted);
    Fixed moved = bracket.high - bracket.low;
    for (std::size_t step = 0U; (step < most_steps) && (moved > close_enough); ++step) {
        const CurvePoint point = curve_at(curve, guess);
        const Fixed excess = point.mv - wanted;
        if (excess > 0) {
            bracket.high = guess;
            bracket.high_is_end = false;
        } else {
            bracket.low = guess;
        }
        const float way = way_to_root(rough(excess), point);
        // This form of the comparison is also false for NaN.
        const bool within_reach = std::fabs(way) <= rough(bracket.high - bracket.low);
        const Fixed next = within_reach ? (guess + to_fixed(way)) : guess;
        const bool inside = within_reach && (next >= bracket.low) && (next <= bracket.high);
        // Beyond the range both ends of the bracket are the end of the range, and the search ends there.
        moved = inside ? static_cast<Fixed>(magnitude(next - guess)) : (bracket.high - bracket.low);
        guess = inside ? next : bracket.inner();
    }
    return from_fixed(guess);
}

}  // namespace canproof::ax188001
