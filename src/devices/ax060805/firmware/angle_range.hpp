// The part of a turn in which an angle is given (AX060805, 3.5, Table 8).
#pragma once

#include <cstdint>

namespace canproof::ax060805 {

/// Degrees. A whole turn, -180…180 or 0…360, gives every angle; a smaller span, 0…90, the distance from the level.
struct AngleSpan {
    std::int16_t lower{0};
    std::int16_t upper{0};
};

/// `degrees` from -180 to 180 as it is given in `span`: moved by a whole turn when it lies below, or, in a span smaller
/// than that, without sign, when it lies above folded at the upper end, and never below the lower one. Of 0…360 the end
/// itself does not occur.
float in_span(float degrees, const AngleSpan& span) noexcept;

}  // namespace canproof::ax060805
