// SPDX-License-Identifier: Apache-2.0
// Tests the search for a temperature of the AX188001 with curves that no thermocouple has.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "devices/ax188001/firmware/thermocouple.hpp"
#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "tests/support/shows_rule.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

/// Returns a curve of one polynomial from `lowest` to `highest` degrees. Voltages from `first_mv` to `last_mv` have the
/// first guess `guess`.
ThermocoupleCurve one_piece(double lowest, double highest, const std::array<double, ReferencePiece::size>& coefficients,
                            double first_mv, double last_mv, double guess) {
    ThermocoupleCurve curve{};
    curve.reference[0] = reference_piece(lowest, highest, coefficients);
    curve.reference_count = 1U;
    curve.inverse[0] = inverse_piece(first_mv, last_mv, {guess});
    curve.inverse_count = 1U;
    curve.lowest = to_fixed(lowest);
    curve.highest = to_fixed(highest);
    return curve;
}

}  // namespace

TEST(Thermocouple, TemperatureSearchWithABadFirstGuessGoesOnFromTheEndOfTheRange) {
    shows_rule("work is bounded");
    // The curve is t^3 from 0 to 100, the first guess 1. The parabola 1 + 3 d + 3 d^2 reaches 970299 at d = 568, far
    // beyond 100. The parabola at 100 leads to 98.99997, and the next one to the root, 99.
    const ThermocoupleCurve cubic = one_piece(0.0, 100.0, {0.0, 0.0, 0.0, 1.0}, 0.0, 1e6, 1.0);
    EXPECT_NEAR(exact_celsius(cubic, 970299.0), 99.0, 1e-6);
}

TEST(Thermocouple, TemperatureSearchContinuesAfterAStepFromTToMinusT) {
    shows_rule("work is bounded");
    // The curve is t^3 from -100 to 100, the first guess 10, the target -5000. A parabola at the first guess does not
    // reach the target, so its slope 300 alone gives the step: 6000 / 300 = 20 down, to -10. The search must not end
    // there. The root is -17.0997594668.
    const ThermocoupleCurve cubic = one_piece(-100.0, 100.0, {0.0, 0.0, 0.0, 1.0}, -1e6, 1e6, 10.0);
    EXPECT_NEAR(exact_celsius(cubic, -5000.0), -17.0997594668, 1e-6);
}

TEST(Thermocouple, TemperatureSearchFollowsTheSlopeWhereTheParabolaDoesNotReachTheVoltage) {
    shows_rule("work is bounded");
    // The curve is t^3 / 1000 from -200 to 100, the first guess 10, where the voltage is 1 and the slope 0.3. The
    // parabola at 10 turns at 1 - 0.3^2 / (2 * 0.06) = 0.25, above the target -8. The slope leads 9 / 0.3 = 30 down, to
    // -20, where the voltage is -8.
    const ThermocoupleCurve cubic = one_piece(-200.0, 100.0, {0.0, 0.0, 0.0, 0.001}, -1e4, 1e3, 10.0);
    EXPECT_NEAR(exact_celsius(cubic, -8.0), -20.0, 1e-6);
}

TEST(Thermocouple, TemperatureSearchAtTheLowestVoltageOfTheInverseFunctionBeginsWithItsTemperature) {
    shows_rule("work is bounded");
    // The curve is t^3 from 0 to 100. The inverse function begins at 1000, with the root 10. From the end of the range,
    // 0, the slope 0 leads to 100, and further steps to 66.7, 44.5 and 29.8.
    const ThermocoupleCurve cubic = one_piece(0.0, 100.0, {0.0, 0.0, 0.0, 1.0}, 1000.0, 1e6, 10.0);
    EXPECT_NEAR(exact_celsius(cubic, 1000.0), 10.0, 1e-6);
}

TEST(Thermocouple, TemperatureSearchStepsAcrossTheWholeInterval) {
    shows_rule("work is bounded");
    // The curve is t from 0 to 100, the first guess 100. The first step is as long as the interval and ends at the
    // root.
    const ThermocoupleCurve line = one_piece(0.0, 100.0, {0.0, 1.0}, -1.0, 100.0, 100.0);
    EXPECT_NEAR(exact_celsius(line, 0.0), 0.0, 1e-6);
}

TEST(Thermocouple, OscillatingTemperatureSearchEnds) {
    shows_rule("work is bounded");
    // The curve is t - 5 below 0 degC and t + 5 above. A Newton step from 5 leads to -5, and the next one back to 5.
    ThermocoupleCurve gap{};
    gap.reference[0] = reference_piece(-100.0, 0.0, {-5.0, 1.0});
    gap.reference[1] = reference_piece(0.0, 100.0, {5.0, 1.0});
    gap.reference_count = 2U;
    gap.inverse[0] = inverse_piece(-1e6, 1e6, {5.0});
    gap.inverse_count = 1U;
    gap.lowest = to_fixed(-100.0);
    gap.highest = to_fixed(100.0);
    EXPECT_LE(std::fabs(exact_celsius(gap, 0.0)), 5.0);
}

TEST(Thermocouple, SearchWithoutConvergenceEndsAtItsLastStep) {
    shows_rule("work is bounded");
    // The curve jumps at 40 degC and is flat elsewhere, so Newton steps lead nowhere, and the bisection runs to its
    // limit.
    ThermocoupleCurve step{};
    step.reference[0] = reference_piece(0.0, 40.0, {});
    step.reference[1] = reference_piece(40.0, 1e6, {10.0});
    step.reference_count = 2U;
    step.inverse[0] = inverse_piece(0.0, 10.0, {});
    step.inverse_count = 1U;
    step.highest = to_fixed(1e6);
    // The first of four steps looks at 0 degC, the second at the other end of the range. The third looks at the middle,
    // 5e5, and the fourth at 2.5e5. The search ends in the middle of the remaining interval.
    EXPECT_NEAR(exact_celsius(step, 5.0), 1.25e5, 1e-6);
}

TEST(Thermocouple, SearchWithoutConvergenceGoesOnInTheUpperHalfOfTheInterval) {
    shows_rule("work is bounded");
    // The curve jumps at -1e5 degC and is flat elsewhere; the range ends at 0 degC.
    ThermocoupleCurve step{};
    step.reference[0] = reference_piece(-1e6, -1e5, {});
    step.reference[1] = reference_piece(-1e5, 0.0, {10.0});
    step.reference_count = 2U;
    step.inverse[0] = inverse_piece(0.0, 10.0, {-1e6});
    step.inverse_count = 1U;
    step.lowest = to_fixed(-1e6);
    // The first of four steps looks at -1e6 degC, the second at the other end of the range. The third looks at the
    // middle, -5e5, and the fourth at -2.5e5. Both lie below the jump, so the search ends between -2.5e5 and 0.
    EXPECT_NEAR(exact_celsius(step, 5.0), -1.25e5, 1e-6);
}

TEST(Thermocouple, TemperatureSearchBisectsWhenRoundingLeadsBelowTheInterval) {
    shows_rule("work is bounded");
    // The curve is t from 0 to 100, the first guess 33.0000137, the target 0. The search rounds the length of its
    // interval up to single precision, and lets a step be so long. So the step to 0 ends a little below the interval.
    // Then the middle is the next guess, in each of the four steps: 33.0000137 / 2^4.
    const ThermocoupleCurve line = one_piece(0.0, 100.0, {0.0, 1.0}, -1.0, 100.0, 33.0000137);
    EXPECT_NEAR(exact_celsius(line, 0.0), 33.0000137 / 16.0, 1e-6);
}

}  // namespace canproof::test
