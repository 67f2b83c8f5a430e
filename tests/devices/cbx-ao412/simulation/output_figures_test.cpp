// SPDX-License-Identifier: Apache-2.0
#include "devices/cbx-ao412/simulation/output_figures.hpp"

#include <gmock/gmock.h>

namespace canproof::test {

namespace {

using namespace cbx_ao412;
using namespace host;
using ::testing::SizeIs;

TEST(CbxOutputFigures, ReplayOfTheManualTelegramsGivesTheOutputsOfTheManual) {
    const LinePlot plot = analog_outputs_plot();
    ASSERT_THAT(plot.curves, SizeIs(4));
    // Section 7.10.2.3 of the CAN-CBX-AO412 manual: 3EB3h is 5.0 V, C14Dh is -5.0 V; the lowest of the 12 bits is about
    // 5 mV.
    const auto& first = plot.curves[0].points;
    ASSERT_GE(first.size(), 3U);
    EXPECT_DOUBLE_EQ(first[2].first, 0.010);
    EXPECT_NEAR(first[2].second, 5.0, 0.005);
    const auto& second = plot.curves[1].points;
    ASSERT_GE(second.size(), 5U);
    EXPECT_DOUBLE_EQ(second[2].first, 0.020);
    EXPECT_NEAR(second[2].second, -5.0, 0.005);
    EXPECT_NEAR(second[4].second, 5.0, 0.005);  // the RPDO at 40 ms has set 5 V
}

}  // namespace

}  // namespace canproof::test
