// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/angle_range.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr std::int32_t full_turn = 360;

}  // namespace

static_assert(implements<req::INC_RANGE_001> && implements<req::INC_RANGE_004> && implements<req::INC_RANGE_005>);
float in_span(const float degrees, const AngleSpan& span) noexcept {
    const float lower = static_cast<float>(span.lower);
    const float upper = static_cast<float>(span.upper);
    if ((static_cast<std::int32_t>(span.upper) - span.lower) != full_turn) {
        const float distance = std::fabs(degrees);
        return std::fmax(lower, (distance > upper) ? ((2.0F * upper) - distance) : distance);
    }
    if (degrees < lower) {
        const float turned = degrees + static_cast<float>(full_turn);
        return (turned < upper) ? turned : lower;  // an angle just below 0 can round up to 360
    }
    return degrees;
}

}  // namespace canproof::ax060805
