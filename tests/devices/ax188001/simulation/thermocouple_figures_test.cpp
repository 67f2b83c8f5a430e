// SPDX-License-Identifier: Apache-2.0
// Checks that the figures of the AX188001 show the properties of its manual (1.1, appendix A).
#include "devices/ax188001/simulation/thermocouple_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generated/ax188001/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::host::test {

namespace {

using namespace ax188001;
using canproof::test::verifies;

double worst(const Curve& curve) {
    double most = 0.0;
    for (const auto& [x, y] : curve.points) {
        most = std::max(most, std::fabs(y));
    }
    return most;
}

double hottest(const Curve& curve) {
    return curve.points.back().first;
}

}  // namespace

TEST(ThermocoupleFigures, ConversionOfAllEightTypesErrsByAtMostAFiftiethOfADegree) {
    verifies<req::TCS_CONV_002>();
    const LinePlot plot = conversion_error_plot();
    ASSERT_EQ(plot.curves.size(), 8U);
    for (const Curve& curve : plot.curves) {
        EXPECT_EQ(curve.points.size(), 601U);
        EXPECT_LT(worst(curve), 0.02) << curve.name;
    }
    EXPECT_EQ(plot.curves[1].name, "K");
    EXPECT_DOUBLE_EQ(plot.curves[1].points.front().first, -270.0);
    EXPECT_DOUBLE_EQ(hottest(plot.curves[1]), 1372.0);
    EXPECT_DOUBLE_EQ(hottest(plot.curves[7]), 1820.0);
}

TEST(ThermocoupleFigures, InverseFunctionsAloneErrByLessThan61Millidegrees) {
    verifies<req::TCS_CONV_009>();
    const LinePlot plot = inverse_error_plot();
    ASSERT_EQ(plot.curves.size(), 8U);
    double most = 0.0;
    for (const Curve& curve : plot.curves) {
        EXPECT_LT(worst(curve), 0.0605) << curve.name;
        most = std::max(most, worst(curve));
    }
    EXPECT_GT(most, 0.02);
    EXPECT_NEAR(plot.curves[1].points.front().first, -200.0, 0.05);
}

TEST(ThermocoupleFigures, ChannelErrsByAtMostOneDegree) {
    verifies<req::TCS_IN_012>();
    const LinePlot plot = channel_error_plot();
    ASSERT_EQ(plot.curves.size(), 8U);
    for (const Curve& curve : plot.curves) {
        EXPECT_EQ(curve.points.size(), 301U);
        EXPECT_LT(worst(curve), 1.0) << curve.name;
        EXPECT_GT(worst(curve), 0.001) << curve.name;  // the error is not zero, because the converter has steps
    }
}

TEST(ThermocoupleFigures, RampPlotMarksEachEmcyMessage) {
    verifies<req::TCS_LIM_003>();
    const LinePlot plot = ramp_plot();
    std::vector<std::string> words;
    for (const PlotMark& mark : plot.marks) {
        words.push_back(mark.word);
    }
    // The calculation of these times is in replay_test.cpp.
    EXPECT_EQ(words, (std::vector<std::string>{"low warning 5.000", "cleared 12.045", "high warning 31.070",
                                               "shutdown 44.105", "open circuit 52.355", "cleared 55.110",
                                               "cleared 61.050", "cleared 74.085", "low warning 93.110"}));
    ASSERT_EQ(plot.curves.size(), 2U);
    const Curve& shown = plot.curves[1];
    int gaps = 0;
    for (const auto& [second, celsius] : shown.points) {
        gaps += std::isnan(celsius) ? 1 : 0;
        if (second > 20.0 && second < 21.0) {
            EXPECT_NEAR(celsius, 58.0, 0.1);  // the value sent at 20.100 s was read at 19.965 s: -32 + 9 * 10 = 58 degC
        }
    }
    EXPECT_EQ(gaps,
              8);  // no value in the TPDOs from 48.1 s to 55.1 s: the circuit is open from 47.355 s to 55.11 s
}

}  // namespace canproof::host::test
