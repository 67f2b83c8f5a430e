// SPDX-License-Identifier: Apache-2.0
// The range of values of an angle (AX060805, 3.5, Table 8).
#pragma once

#include <cstdint>

namespace canproof::ax060805 {

/// The ends of a range of angles, in degrees. A span of a whole turn (-180…180 or 0…360) distinguishes all angles; the
/// smaller span 0…90 gives only the distance from the horizontal, without its direction.
struct AngleSpan {
    std::int16_t lower{0};
    std::int16_t upper{0};
};

/// Converts `degrees` (-180…180) to `span`. In a span of a whole turn, values below the lower end are moved by 360; 360
/// itself does not occur in 0…360. In a smaller span the sign is dropped, values above the upper end are mirrored at
/// this end, and values below the lower end are clamped.
float in_span(float degrees, const AngleSpan& span) noexcept;

}  // namespace canproof::ax060805
