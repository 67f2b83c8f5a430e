#include "firmware/blocks/angle_range.hpp"

#include <cmath>

namespace canproof {

namespace {

constexpr float full_turn = 360.0F;

}  // namespace

float in_span(const float degrees, const AngleSpan& span) noexcept {
    if ((span.upper - span.lower) < full_turn) {
        const float distance = std::fabs(degrees);
        return std::fmax(span.lower, (distance > span.upper) ? ((2.0F * span.upper) - distance) : distance);
    }
    if (degrees < span.lower) {
        const float turned = degrees + full_turn;
        return (turned < span.upper) ? turned : span.lower;  // an angle just below 0 can round up to 360
    }
    return degrees;
}

}  // namespace canproof
