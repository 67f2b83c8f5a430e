// SPDX-License-Identifier: Apache-2.0
// Checks that the figures of the AX130751 show the examples of its manual.
#include "devices/ax130751/simulation/converter_figures.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

namespace {

using namespace ax130751;

double at(const Curve& curve, double x) {
    for (const auto& [one, y] : curve.points) {
        if (one == x) {
            return y;
        }
    }
    ADD_FAILURE() << curve.name << " has no point at " << x;
    return 0.0;
}

}  // namespace

TEST(ConverterFigures, JoystickHasADeadbandAndTwoMirroredSlopesOnEachSide) {
    const LinePlot plot = joystick_plot();
    ASSERT_EQ(plot.curves.size(), 2U);
    for (const double outward : {0.0, 25.0, 30.0, 50.0}) {
        EXPECT_NEAR(at(plot.curves[0], 50.0 + outward), at(plot.curves[1], 50.0 - outward), 0.001) << outward;
        EXPECT_NEAR(at(plot.curves[1], 50.0 + outward), 0.0, 0.001) << outward;
    }
    EXPECT_NEAR(at(plot.curves[0], 55.0), 0.0, 0.001);
    EXPECT_NEAR(at(plot.curves[0], 75.0), 3.0, 0.001);
    EXPECT_NEAR(at(plot.curves[0], 100.0), 10.0, 0.001);
}

TEST(ConverterFigures, TrimPotentiometerMovesTheCurveOfTheJoystickByUpToAQuarterOfTheFullRange) {
    const LinePlot plot = trimmed_joystick_plot();
    ASSERT_EQ(plot.curves.size(), 3U);
    EXPECT_DOUBLE_EQ(at(plot.curves[0], 0.0), 0.0);
    EXPECT_DOUBLE_EQ(at(plot.curves[0], 100.0), 75.0);
    EXPECT_DOUBLE_EQ(at(plot.curves[1], 50.0), 50.0);
    EXPECT_DOUBLE_EQ(at(plot.curves[2], 0.0), 25.0);
    EXPECT_DOUBLE_EQ(at(plot.curves[2], 100.0), 100.0);
}

TEST(ConverterFigures, ThirtySlopesOfThreeLookupTablesFormOneCurve) {
    const LinePlot plot = thirty_slopes_plot();
    ASSERT_EQ(plot.marks.size(), 3U);
    EXPECT_EQ(plot.marks[0].word, "table 1");
    EXPECT_DOUBLE_EQ(plot.marks[1].x, 100.0);
    EXPECT_EQ(plot.marks[1].word, "table 2");
    EXPECT_DOUBLE_EQ(plot.marks[2].x, 200.0);
    EXPECT_EQ(plot.marks[2].word, "table 3");
    for (int point = 0; point <= 30; ++point) {
        EXPECT_NEAR(at(plot.curves[0], 10.0 * point), 3.0 * point + (point % 2 == 1 ? 5.0 : 0.0), 0.001) << point;
    }
}

}  // namespace canproof::host::test
