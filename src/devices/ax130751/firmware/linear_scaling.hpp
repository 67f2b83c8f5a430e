// SPDX-License-Identifier: Apache-2.0
// A straight line between two points, constant outside of them (AX130751, 1.3, Figures 2 and 3).
#pragma once

#include <cstdint>

#include "devices/ax130751/firmware/quotient.hpp"
#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

/// A line through (x1, y1) and (x2, y2), where x1 < x2; y1 may be greater than y2.
struct LinearScaling {
    double x1{0.0};
    double x2{1.0};
    double y1{0.0};
    double y2{1.0};
};

using ScalingPosition = generated::ax130751::control_response::Position;

/// Returns whether x lies below x1, above x2, or within; x1 and x2 themselves are within.
constexpr ScalingPosition position_of(const double x, const LinearScaling& scaling) noexcept {
    if (x < scaling.x1) {
        return ScalingPosition::below;
    }
    return (x > scaling.x2) ? ScalingPosition::above : ScalingPosition::within;
}

/// Returns y on the line through both points; x1 and x2 differ.
inline double on_line(const double x, const LinearScaling& scaling) noexcept {
    return scaling.y1 + quotient((x - scaling.x1) * (scaling.y2 - scaling.y1), scaling.x2 - scaling.x1);
}

/// Returns y for x: y1 at and below x1, y2 at and above x2.
inline double scale(const double x, const LinearScaling& scaling) noexcept {
    if (x <= scaling.x1) {
        return scaling.y1;
    }
    if (x >= scaling.x2) {
        return scaling.y2;
    }
    return on_line(x, scaling);
}

}  // namespace canproof::ax130751
