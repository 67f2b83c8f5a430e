// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ramp.hpp"

#include <cmath>

#include "devices/ax130751/firmware/quotient.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

bool is_same(const double a, const double b) noexcept {
    return (a <= b) && (a >= b);
}

bool is_same(const RampTimes& a, const RampTimes& b) noexcept {
    return is_same(a.span, b.span) && (a.up.us == b.up.us) && (a.down.us == b.down.us);
}

}  // namespace

void Ramp::set(const double value) noexcept {
    start_ = value;
    target_ = value;
}

double Ramp::follow(const double target, const RampTimes& times, const Instant now) noexcept {
    if ((!is_same(target, target_)) || (!is_same(times, times_))) {
        start_ = value_at(now);
        since_ = now;
        target_ = target;
        times_ = times;
    }
    return value_at(now);
}

double Ramp::hold(const Instant now) noexcept {
    const double held = value_at(now);
    set(held);
    return held;
}

static_assert(implements<req::AOR_OUT_012> && implements<req::AOR_OUT_013> && implements<req::AOR_OUT_043>);
double Ramp::value_at(const Instant now) const noexcept {
    const double way = target_ - start_;
    const bool rising = way > 0.0;
    const Duration length = rising ? times_.up : times_.down;
    if ((length.us == 0U) || (times_.span <= 0.0)) {
        return target_;
    }
    const double gone =
        quotient(times_.span * static_cast<double>(elapsed(since_, now).us), static_cast<double>(length.us));
    if (gone >= std::fabs(way)) {
        return target_;
    }
    return rising ? (start_ + gone) : (start_ - gone);
}

bool Ramp::is_moving(const Instant now) const noexcept {
    return !is_same(value_at(now), target_);
}

}  // namespace canproof::ax130751
