// SPDX-License-Identifier: Apache-2.0
// Tests plots of the outputs of a run: between two changes an output is drawn as a step, not as a slope.
#include "host/report/output_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::Pair;
using testing::SizeIs;

LinePlot plot_of(const std::string& csv, const std::vector<std::string>& signals = {}) {
    std::istringstream in{"seconds,signal,value\n" + csv};
    return output_plot(in, "out.csv", signals);
}

}  // namespace

TEST(OutputPlot, SignalIsDrawnAsStepsBetweenItsChanges) {
    const LinePlot plot = plot_of("0,aout1,0\n0,aout2,0\n1.5,aout1,5\n2,aout2,-1\n4,aout1,2.5\n");
    ASSERT_THAT(plot.curves, SizeIs(2));
    EXPECT_EQ(plot.curves[0].name, "aout1");
    EXPECT_THAT(plot.curves[0].points, ElementsAre(Pair(0.0, 0.0), Pair(1.5, 0.0), Pair(1.5, 5.0), Pair(4.0, 5.0),
                                                   Pair(4.0, 2.5), Pair(4.0, 2.5)));
    EXPECT_THAT(plot.curves[1].points, ElementsAre(Pair(0.0, 0.0), Pair(2.0, 0.0), Pair(2.0, -1.0), Pair(4.0, -1.0)));
}

TEST(OutputPlot, ConstantSignalIsLeftOutUnlessItIsSelected) {
    const std::string csv = "0,led_p,1\n0,aout1,0\n1,aout1,5\n";
    EXPECT_EQ(plot_of(csv).curves.at(0).name, "aout1");
    EXPECT_THAT(plot_of(csv).curves, SizeIs(1));
    EXPECT_THAT(plot_of(csv, {"led_p"}).curves.at(0).points, ElementsAre(Pair(0.0, 1.0), Pair(1.0, 1.0)));
}

TEST(OutputPlot, BytesThatAreNotUtf8AndControlCharactersAreReplacedInNames) {
    std::istringstream in{"0,gr\xF6sse\x01,0\n1,gr\xF6sse\x01,5\n"};
    const LinePlot plot = output_plot(in, "m\xE4rz.csv", {});
    EXPECT_EQ(plot.title, "m\xEF\xBF\xBDrz.csv");  // U+FFFD in UTF-8
    EXPECT_EQ(plot.curves.at(0).name, "gr\xEF\xBF\xBDsse\xEF\xBF\xBD");
}

TEST(OutputPlot, FileWithNothingToDrawIsRefused) {
    EXPECT_THROW(plot_of(""), InputError);
    EXPECT_THROW(plot_of("0,aout1,0\n"), InputError);
    EXPECT_THROW(plot_of("0,aout1,0\n1,aout1,5\n", {"aout9"}), InputError);
    EXPECT_THROW(plot_of("0,aout1\n"), InputError);
}

}  // namespace canproof::host::test
