// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/low_pass.hpp"

#include "devices/ax060805/firmware/angle_math.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr float two_pi = 6.28318531F;
constexpr float microseconds_per_second = 1.0e6F;
constexpr float milliseconds_per_second = 1.0e3F;

float approach(const float from, const float to, const float share) noexcept {
    return from + (share * (to - from));
}

}  // namespace

float low_pass_coefficient(const float cut_off_hz, const Duration period) noexcept {
    const float seconds = static_cast<float>(period.us) / microseconds_per_second;
    return 1.0F - exp_of_negative((two_pi * cut_off_hz) * seconds);
}

float low_pass_delay_ms(const float cut_off_hz) noexcept {
    return milliseconds_per_second / (two_pi * cut_off_hz);
}

static_assert(implements<req::INC_FILTER_003> && implements<req::INC_FILTER_007>);
const Vector3& LowPass::update(const Vector3& sample, const float coefficient) noexcept {
    if (!started_ || (coefficient >= 1.0F)) {
        output_ = sample;
        started_ = true;
    } else {
        output_ = Vector3{approach(output_.x, sample.x, coefficient), approach(output_.y, sample.y, coefficient),
                          approach(output_.z, sample.z, coefficient)};
    }
    return output_;
}

}  // namespace canproof::ax060805
