// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/firmware/thermocouple_curves.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"

namespace canproof::ax188001 {

namespace {

namespace own = generated::ax188001;
using own::SensorType;

const ExponentialTerm k_exponential =
    exponential_term(own::k_exponential_a0, own::k_exponential_a1, own::k_exponential_a2);

static_assert(implements<req::TCS_T_REFERENCE>);
constexpr ReferencePiece reference_piece_of(const own::reference_function::Row& row) noexcept {
    ReferencePiece piece = reference_piece(row.from_c, row.to_c,
                                           {row.c0, row.c1, row.c2, row.c3, row.c4, row.c5, row.c6, row.c7, row.c8,
                                            row.c9, row.c10, row.c11, row.c12, row.c13, row.c14});
    if ((row.type == SensorType::k) && (row.from_c >= 0.0)) {
        piece.exponential = &k_exponential;
    }
    return piece;
}

static_assert(implements<req::TCS_T_INVERSE>);
constexpr InversePiece inverse_piece_of(const own::inverse_function::Row& row) noexcept {
    return inverse_piece(row.from_mv, row.to_mv,
                         {row.d0, row.d1, row.d2, row.d3, row.d4, row.d5, row.d6, row.d7, row.d8, row.d9, row.d10});
}

static_assert(implements<req::TCS_CONV_001> && implements<req::TCS_CONV_007> && implements<req::TCS_K_B_MINIMUM>);
constexpr ThermocoupleCurve make_curve(const SensorType type) noexcept {
    ThermocoupleCurve curve{};
    for (const auto& row : own::reference_function::rows) {
        if (row.type == type) {
            curve.reference[curve.reference_count] = reference_piece_of(row);
            ++curve.reference_count;
        }
    }
    for (const auto& row : own::inverse_function::rows) {
        if (row.type == type) {
            curve.inverse[curve.inverse_count] = inverse_piece_of(row);
            ++curve.inverse_count;
        }
    }
    static_assert(implements<req::TCS_CONV_012>);
    curve.lowest = (type == SensorType::b) ? to_fixed(own::b_minimum_c) : curve.reference[0].begin;
    curve.highest = curve.reference[curve.reference_count - 1U].end;
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

}  // namespace canproof::ax188001
