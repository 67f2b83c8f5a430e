// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/angle_math.hpp"

#include <cmath>
#include <cstdint>

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr float degrees_per_radian = 57.2957795F;
constexpr float radians_per_degree = 0.0174532925F;
constexpr float half_turn = 180.0F;
constexpr float quarter_turn = 90.0F;
constexpr float eighth_turn = 45.0F;
constexpr float tangent_of_22_5 = 0.414213562F;

/// Returns atan(t) for |t| up to tan 22.5°, by a minimax polynomial of degree 4 in t² (error below 2e-8).
float arctangent_of_small(const float t) noexcept {
    const float z = t * t;
    const float tail = ((((8.05374449538e-2F * z) - 1.38776856032e-1F) * z) + 1.99777106478e-1F) * z;
    return t + (((tail - 3.33329491539e-1F) * z) * t);
}

/// Returns the arctangent in degrees, 0…45, for a ratio of 0…1.
static_assert(implements<req::INC_ANGLE_012>);
float arctangent_of_ratio(const float ratio) noexcept {
    if (ratio <= tangent_of_22_5) {
        return arctangent_of_small(ratio) * degrees_per_radian;
    }
    const float turned = (ratio - 1.0F) / (ratio + 1.0F);  // tan(angle - 45°)
    return eighth_turn + (arctangent_of_small(turned) * degrees_per_radian);
}

/// Returns the sine for |radians| up to pi / 4.
float sine_of_small(const float radians) noexcept {
    const float z = radians * radians;
    const float tail = ((((-1.9515295891e-4F * z) + 8.3321608736e-3F) * z) - 1.6666654611e-1F) * z;
    return radians + (tail * radians);
}

float cosine_of_small(const float radians) noexcept {
    const float z = radians * radians;
    const float tail = (((2.443315711809948e-5F * z) - 1.388731625493765e-3F) * z) + 4.166664568298827e-2F;
    return (1.0F - (0.5F * z)) + ((tail * z) * z);
}

/// Returns the sine of the angle that is `quarters` quarter turns larger than `degrees`.
float sine_ahead(const float degrees, const std::int32_t quarters) noexcept {
    const float nearest = std::floor((degrees / quarter_turn) + 0.5F);
    const float rest = (degrees - (nearest * quarter_turn)) * radians_per_degree;
    const std::int32_t turned = static_cast<std::int32_t>(nearest) + quarters;
    const std::int32_t quadrant = ((turned % 4) + 4) % 4;
    switch (quadrant) {
        case 0:
            return sine_of_small(rest);
        case 1:
            return cosine_of_small(rest);
        case 2:
            return -sine_of_small(rest);
        default:
            return -cosine_of_small(rest);
    }
}

}  // namespace

float atan2_degrees(const float y, const float x) noexcept {
    const float across = std::fabs(y);
    const float along = std::fabs(x);
    if ((across == 0.0F) && (along == 0.0F)) {
        return 0.0F;
    }
    float angle =
        (across <= along) ? arctangent_of_ratio(across / along) : (quarter_turn - arctangent_of_ratio(along / across));
    if (x < 0.0F) {
        angle = half_turn - angle;
    }
    return (y < 0.0F) ? -angle : angle;
}

float sine_of_degrees(const float degrees) noexcept {
    return sine_ahead(degrees, 0);
}

float cosine_of_degrees(const float degrees) noexcept {
    return sine_ahead(degrees, 1);
}

float exp_of_negative(const float x) noexcept {
    // e^-x = (e^(-x/8))^8. The series of e^(-x/8), with x/8 up to 0.5, is used up to the seventh power.
    constexpr std::int32_t terms = 7;
    const float part = -x / 8.0F;
    float sum{1.0F};
    for (std::int32_t term = terms; term >= 1; --term) {
        sum = 1.0F + ((part / static_cast<float>(term)) * sum);
    }
    const float squared = sum * sum;
    const float fourth = squared * squared;
    return fourth * fourth;
}

}  // namespace canproof::ax060805
