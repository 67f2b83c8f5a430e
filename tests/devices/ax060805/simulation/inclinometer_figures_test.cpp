// SPDX-License-Identifier: Apache-2.0
// Checks that the figures of the AX060805 show the properties of its manual (2.1.4, 2.1.5, 5.1.2).
#include "devices/ax060805/simulation/inclinometer_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::host::test {

namespace {

using namespace ax060805;
using canproof::test::verifies;

/// Returns the value of the curve at its point nearest to `x`.
double at(const Curve& curve, double x) {
    const auto nearest = std::min_element(curve.points.begin(), curve.points.end(), [x](const auto& a, const auto& b) {
        return std::fabs(a.first - x) < std::fabs(b.first - x);
    });
    return nearest->second;
}

/// Checks the three angles of the plot at `second`. The input filter delays the angles, which then differ by less than
/// a degree.
void expect_angles(const LinePlot& plot, double second, double pitch, double roll, double gravity) {
    EXPECT_NEAR(at(plot.curves[0], second), pitch, 1.0) << second;
    EXPECT_NEAR(at(plot.curves[1], second), roll, 1.0) << second;
    EXPECT_NEAR(at(plot.curves[2], second), gravity, 1.0) << second;
}

}  // namespace

TEST(InclinometerFigures, TumblePlotShowsTheTiltAnglesOfATurningUnit) {
    verifies<req::INC_ANGLE_003, req::INC_ANGLE_004, req::INC_ANGLE_015, req::INC_ANGLE_013>();
    const LinePlot plot = tumble_plot();
    ASSERT_EQ(plot.curves.size(), 3U);
    // The unit turns by 18 degrees per second about Y, nose up. Beyond 90 degrees it is upside down, so its roll is
    // 180.
    expect_angles(plot, 2.0, 36.0, 0.0, 36.0);
    expect_angles(plot, 7.0, 126.0, 180.0, 126.0);
    expect_angles(plot, 13.0, -126.0, 180.0, 126.0);
    expect_angles(plot, 18.0, -36.0, 0.0, 36.0);
    // From 20 s on, the unit turns about X, right side down.
    expect_angles(plot, 22.0, 0.0, 36.0, 36.0);
    expect_angles(plot, 27.0, 180.0, 126.0, 126.0);
    // From 40 s on, the unit turns about the diagonal. When it has turned by 45 degrees, gravity is (-0.5, 0.5,
    // 0.7071), and both tilt angles are 30.
    expect_angles(plot, 42.5, 30.0, 30.0, 45.0);
}

TEST(InclinometerFigures, EulerPitchStaysWithin90Degrees) {
    verifies<req::INC_ANGLE_005, req::INC_ANGLE_009>();
    const LinePlot plot = euler_tumble_plot();
    for (const auto& [second, pitch] : plot.curves[0].points) {
        EXPECT_LE(std::fabs(pitch), 90.0) << second;
    }
    expect_angles(plot, 7.0, 54.0, 180.0, 126.0);
    // gravity is (-0.5, 0.5, 0.7071), so the roll is atan2(0.5, 0.7071)
    expect_angles(plot, 42.5, 30.0, 35.26, 45.0);
}

TEST(InclinometerFigures, AnglesInSinglePrecisionErrByLessThan100Microdegrees) {
    verifies<req::INC_ANGLE_012>();
    const LinePlot plot = angle_error_plot();
    double worst = 0.0;
    for (const Curve& curve : plot.curves) {
        EXPECT_EQ(curve.points.size(), 3002U);
        for (const auto& [second, error] : curve.points) {
            worst = std::max(worst, std::fabs(error));
        }
    }
    EXPECT_LT(worst, 100.0);
    EXPECT_GT(worst, 0.0);  // an error of exactly zero would mean that nothing was compared
}

TEST(InclinometerFigures, PitchFilteredAt5HzHasSettledAfter200Milliseconds) {
    verifies<req::INC_FILTER_003, req::INC_FILTER_007, req::INC_FILTER_002>();
    const LinePlot plot = settling_plot();
    ASSERT_EQ(plot.curves.size(), 3U);
    EXPECT_EQ(plot.curves[1].name, "5 Hz");
    EXPECT_GE(at(plot.curves[1], 0.2), 28.5);
    EXPECT_LT(at(plot.curves[0], 0.2), 28.5);  // 1 Hz: 1 - exp(-2 pi 0.2) = 72 %
    EXPECT_GE(at(plot.curves[2], 0.02), 28.5);
    for (const Curve& curve : plot.curves) {
        for (const auto& [second, pitch] : curve.points) {
            EXPECT_LE(pitch, 30.0);
        }
    }
}

}  // namespace canproof::host::test
