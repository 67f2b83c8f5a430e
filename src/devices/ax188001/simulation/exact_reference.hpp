// SPDX-License-Identifier: Apache-2.0
// The reference functions of the AX188001's thermocouples in long double. The firmware's fixed point is compared with
// them.
#pragma once

#include <cmath>

#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/tables.hpp"

namespace canproof::ax188001 {

/// Returns the voltage in mV at `celsius`; the type must have a row in the table of the reference functions. Beyond the
/// range of the type, the first or last piece of its function is continued.
inline long double reference_mv_exactly(generated::ax188001::SensorType type, long double celsius) {
    namespace own = generated::ax188001;
    const own::reference_function::Row* piece = nullptr;
    for (const auto& row : own::reference_function::rows) {  // each type's pieces ascend by from_c
        if (row.type == type && (piece == nullptr || celsius >= static_cast<long double>(row.from_c))) {
            piece = &row;
        }
    }
    long double sum = 0.0L;
    for (const double c : {piece->c14, piece->c13, piece->c12, piece->c11, piece->c10, piece->c9, piece->c8, piece->c7,
                           piece->c6, piece->c5, piece->c4, piece->c3, piece->c2, piece->c1, piece->c0}) {
        sum = sum * celsius + static_cast<long double>(c);
    }
    if (type != own::SensorType::k || piece->from_c < 0.0) {
        return sum;
    }
    const long double distance = celsius - static_cast<long double>(own::k_exponential_a2);
    return sum + static_cast<long double>(own::k_exponential_a0) *
                     std::exp(static_cast<long double>(own::k_exponential_a1) * distance * distance);
}

}  // namespace canproof::ax188001
