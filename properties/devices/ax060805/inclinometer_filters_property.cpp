// SPDX-License-Identifier: Apache-2.0
// Properties of the filters of the AX060805 (manual, 3.2, 3.3 and 4.3.11).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "devices/ax060805/firmware/angle_filter.hpp"
#include "devices/ax060805/firmware/low_pass.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

double apart(double a, double b) {
    return std::fabs(std::remainder(a - b, 360.0));
}

float wrapped(double degrees) {
    return static_cast<float>(std::remainder(degrees, 360.0));
}

/// Returns a sequence of angles in degrees, each less than half a turn from the previous one. The angles are not
/// wrapped into one turn.
std::vector<double> any_walk() {
    const auto steps = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(-17900, 17901)));
    std::vector<double> walk;
    double at = 0.0;
    for (const int step : steps) {
        at += step * 0.01;
        walk.push_back(at);
    }
    return walk;
}

}  // namespace

RC_GTEST_PROP(AngleFilterLaw, ShortWindowGivesTheMeanOfTheUnwrappedSamples, ()) {
    verifies<req::INC_AVG_001, req::INC_AVG_006>("property");
    const std::vector<double> walk = any_walk();
    const auto samples = *rc::gen::inRange<std::uint16_t>(1, 65);
    AngleFilter filter;
    filter.restart(AngleFilterKind::moving_average, samples);
    for (std::size_t i = 0; i < walk.size(); ++i) {
        filter.add(wrapped(walk[i]));
        const std::size_t taken = std::min<std::size_t>(samples, i + 1);
        double sum = 0.0;
        for (std::size_t j = i + 1 - taken; j <= i; ++j) {
            sum += walk[j];
        }
        RC_ASSERT(apart(filter.output(), sum / static_cast<double>(taken)) < 1.0e-4);
    }
}

RC_GTEST_PROP(AngleFilterLaw, AverageOfAConstantAngleIsThatAngle, ()) {
    verifies<req::INC_AVG_009>("property");
    const auto samples = *rc::gen::inRange<std::uint16_t>(1, 60001);
    const float angle = static_cast<float>(*rc::gen::inRange(-180000, 180001)) / 1000.0F;
    AngleFilter filter;
    filter.restart(AngleFilterKind::moving_average, samples);
    for (int sample = 0; sample < 3000; ++sample) {
        filter.add(angle);
        RC_ASSERT(apart(filter.output(), angle) < 2.0e-5);
    }
}

RC_GTEST_PROP(AngleFilterLaw, AverageOfASteadyTurnErrsByAtMostTheTurnInOne64thOfALongWindow, ()) {
    verifies<req::INC_AVG_010>("property");
    const auto samples = *rc::gen::inRange<std::uint16_t>(65, 2001);
    const double step = *rc::gen::inRange(-500, 501) * 0.001;
    const double run = std::ceil(samples / 64.0);
    AngleFilter filter;
    filter.restart(AngleFilterKind::moving_average, samples);
    for (int sample = 0; sample < samples + 500; ++sample) {
        filter.add(wrapped(step * sample));
        const double taken = std::min<double>(samples, sample + 1);
        const double mean = step * (sample - (taken - 1.0) / 2.0);
        RC_ASSERT(apart(filter.output(), mean) <= std::fabs(step) * run + 1.0e-4);
    }
}

RC_GTEST_PROP(LowPassLaw, OutputStaysBetweenThePreviousOutputAndTheNewSample, ()) {
    verifies<req::INC_FILTER_002>("property");
    const auto frequency = static_cast<float>(*rc::gen::inRange(1, 51));
    const float share = low_pass_coefficient(frequency, milliseconds(5));
    LowPass filter;
    float before = filter.update({0.0F, 0.0F, 0.0F}, share).x;
    for (const int sample : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-16000, 16001))) {
        const float wanted = static_cast<float>(sample) / 1000.0F;
        const float now = filter.update({wanted, 0.0F, 0.0F}, share).x;
        RC_ASSERT(now >= std::min(before, wanted) - 1e-5F && now <= std::max(before, wanted) + 1e-5F);
        before = now;
    }
}

}  // namespace canproof::test
