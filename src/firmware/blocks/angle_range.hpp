// The part of a turn in which an angle is given (AX060805, 3.5, Table 8).
#pragma once

namespace canproof {

/// Degrees. A whole turn, -180…180 or 0…360, gives every angle; a smaller span, 0…90, the distance from the level.
struct AngleSpan {
    float lower{-180.0F};
    float upper{180.0F};
};

/// `degrees` from -180 to 180 as it is given in `span`: moved by a whole turn when it lies below, or, in a span smaller
/// than that, without sign, when it lies above folded at the upper end, and never below the lower one. Of 0…360 the end
/// itself does not occur.
float in_span(float degrees, const AngleSpan& span) noexcept;

}  // namespace canproof
