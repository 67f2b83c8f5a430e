#include "firmware/blocks/thermocouple_curves.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"

namespace canproof {

namespace {

namespace own = generated::ax188001;
using own::SensorType;

/// How many coefficients there are up to the last that is not zero.
template <std::size_t Size>
constexpr std::size_t terms_of(const std::array<double, Size>& coefficients) noexcept {
    std::size_t terms{Size};
    while ((terms > 0U) && (coefficients[terms - 1U] <= 0.0) && (coefficients[terms - 1U] >= 0.0)) {
        --terms;
    }
    return terms;
}

static_assert(implements<req::TCS_T_REFERENCE> && implements<req::TCS_K_EXPONENTIAL_A0> &&
              implements<req::TCS_K_EXPONENTIAL_A1> && implements<req::TCS_K_EXPONENTIAL_A2>);
constexpr ReferencePiece reference_piece_of(const own::t_tcs_t_reference::Row& row) noexcept {
    ReferencePiece piece{};
    piece.from_c = row.from_c;
    piece.to_c = row.to_c;
    piece.coefficients = {row.c0, row.c1, row.c2,  row.c3,  row.c4,  row.c5,  row.c6, row.c7,
                          row.c8, row.c9, row.c10, row.c11, row.c12, row.c13, row.c14};
    piece.terms = terms_of(piece.coefficients);
    if ((row.type == SensorType::k) && (row.from_c >= 0.0)) {
        piece.exponential = ExponentialTerm{own::k_exponential_a0, own::k_exponential_a1, own::k_exponential_a2};
    }
    return piece;
}

static_assert(implements<req::TCS_T_INVERSE>);
constexpr InversePiece inverse_piece_of(const own::t_tcs_t_inverse::Row& row) noexcept {
    InversePiece piece{};
    piece.from_mv = row.from_mv;
    piece.to_mv = row.to_mv;
    piece.coefficients = {row.d0, row.d1, row.d2, row.d3, row.d4, row.d5, row.d6, row.d7, row.d8, row.d9, row.d10};
    piece.terms = terms_of(piece.coefficients);
    return piece;
}

static_assert(implements<req::TCS_CONV_001> && implements<req::TCS_CONV_007> && implements<req::TCS_K_B_MINIMUM>);
constexpr ThermocoupleCurve make_curve(const SensorType type) noexcept {
    ThermocoupleCurve curve{};
    for (const auto& row : own::t_tcs_t_reference::rows) {
        if (row.type == type) {
            curve.reference[curve.reference_count] = reference_piece_of(row);
            ++curve.reference_count;
        }
    }
    for (const auto& row : own::t_tcs_t_inverse::rows) {
        if (row.type == type) {
            curve.inverse[curve.inverse_count] = inverse_piece_of(row);
            ++curve.inverse_count;
        }
    }
    curve.lowest_c = (type == SensorType::b) ? own::b_minimum_c : curve.reference[0].from_c;
    curve.highest_c = curve.reference[curve.reference_count - 1U].to_c;
    return curve;
}

const ThermocoupleCurve type_j = make_curve(SensorType::j);
const ThermocoupleCurve type_k = make_curve(SensorType::k);
const ThermocoupleCurve type_n = make_curve(SensorType::n);
const ThermocoupleCurve type_r = make_curve(SensorType::r);
const ThermocoupleCurve type_s = make_curve(SensorType::s);
const ThermocoupleCurve type_t = make_curve(SensorType::t);
const ThermocoupleCurve type_e = make_curve(SensorType::e);
const ThermocoupleCurve type_b = make_curve(SensorType::b);

}  // namespace

static_assert(implements<req::TCS_E_SENSOR_TYPE>);
const ThermocoupleCurve& thermocouple_curve(const SensorType type) noexcept {
    switch (type) {
        case SensorType::k:
            return type_k;
        case SensorType::n:
            return type_n;
        case SensorType::r:
            return type_r;
        case SensorType::s:
            return type_s;
        case SensorType::t:
            return type_t;
        case SensorType::e:
            return type_e;
        case SensorType::b:
            return type_b;
        case SensorType::j:
        default:
            return type_j;
    }
}

}  // namespace canproof
