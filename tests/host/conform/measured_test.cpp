// SPDX-License-Identifier: Apache-2.0
// Tests the statistics of measured times and the bus load of a conformance run.
#include "host/conform/link/measured.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "host/conform/link/bus_use.hpp"
#include "host/conform/run/conform_report.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::conform::test {

TEST(ConformSpread, SpreadIsSmallestMedianMeanAndLargest) {
    const Spread spread = spread_of({10, 40, 25});
    EXPECT_EQ(spread.count, 3U);
    EXPECT_EQ(spread.smallest, 10U);
    EXPECT_EQ(spread.median, 25U);
    EXPECT_EQ(spread.mean, 25U);
    EXPECT_EQ(spread.percentile_99, 40U);
    EXPECT_EQ(spread.largest, 40U);
    EXPECT_EQ(spread_of({}).count, 0U);
}

TEST(ConformSpread, Of100MeasuredTimesThe99thPercentileIsThe99th) {
    std::vector<std::uint64_t> times(100);
    std::iota(times.begin(), times.end(), 1U);  // the times are 1 to 100
    EXPECT_EQ(spread_of(times).percentile_99, 99U);
    EXPECT_EQ(spread_of(times).median, 50U);
}

TEST(ConformHistogram, HistogramCountsEachTimeInOneOfFortyBins) {
    const Histogram histogram = histogram_of({{100, 205, 209, 500}, {}, {}});
    EXPECT_EQ(histogram.low, 100.0);
    EXPECT_EQ(histogram.width, 10.0);  // 400 µs in 40 bins
    std::vector<std::size_t> wanted(40, 0U);
    wanted[0] = 1;
    wanted[10] = 2;
    wanted[39] = 1;  // the largest time is in the last bin
    EXPECT_EQ(histogram.counts, wanted);
}

TEST(ConformHistogram, HistogramRangeIncludesLimitsNearTheMeasuredTimes) {
    const Histogram histogram = histogram_of({{100}, TimeLimits{80.0, 120.0}, {}});
    EXPECT_EQ(histogram.low, 80.0);
    EXPECT_EQ(histogram.width, 1.0);
    EXPECT_EQ(histogram.counts[20], 1U);
}

TEST(ConformHistogram, HistogramRangeOmitsLimitsFarFromTheMeasuredTimes) {
    const Histogram far = histogram_of({{100}, {}, TimeLimits{0.0, 1000000.0}});
    EXPECT_EQ(far.low, 0.0);
    EXPECT_EQ(far.width, 2.5);  // 40 bins of 2.5 µs cover 0 to 100 µs
    EXPECT_EQ(far.counts[39], 1U);
    const Histogram open = histogram_of({{100, 140}, {}, TimeLimits{100.0, std::numeric_limits<double>::infinity()}});
    EXPECT_EQ(open.low, 100.0);
    EXPECT_EQ(open.width, 1.0);
}

TEST(ConformHistogram, TimesThatAreAllTheSameFillOneBin) {
    const Histogram histogram = histogram_of({{7, 7, 7}, {}, {}});
    EXPECT_EQ(histogram.counts[20], 3U);  // the bin in the middle, from 6.5 to 7.5
    EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::size_t{0}), 3U);
}

TEST(ConformMeasured, HighestLimitOfTheAddedMeasurementsIsKept) {
    Measured measured;
    measured.add(5, 1000);
    measured.add(6, 2000);
    measured.add(7, 500);
    EXPECT_EQ(measured.times, (std::vector<std::uint64_t>{5, 6, 7}));
    EXPECT_EQ(measured.of_each->most, 2000.0);
}

TEST(ConformBusUse, FramesAreAddedUpAndTheBusiestSecondIsFound) {
    const Frame frame = parse_frame("605#4000100000000000", "test");
    const std::uint64_t bits = frame_bits(frame) + 3U;  // bits of the frame and of the intermission after it
    BusUse use;
    use.add({Instant{100}, frame, true});
    use.add({Instant{1200000}, frame, false});
    use.add({Instant{1999999}, frame, true});
    use.add({Instant{2000000}, frame, false});
    EXPECT_EQ(use.frames(), 4U);
    EXPECT_EQ(use.own_frames(), 2U);
    EXPECT_EQ(use.bits(), 4U * bits);
    EXPECT_EQ(use.busiest_second(), 3U * bits);  // the three frames that end from 1.2 s to 2.0 s
    // the new frame comes a whole second after the frame at 1.999999 s, so no second contains both
    use.add({Instant{2999999}, frame, false});
    EXPECT_EQ(use.busiest_second(), 3U * bits);
}

TEST(ConformBusUse, LoadOfARunBelowOneSecondIsThatOfTheWholeRun) {
    const Frame frame = parse_frame("605#4000100000000000", "test");
    ConformReport report;
    report.bit_rate = 125000;
    report.time = milliseconds(500);
    report.bus_use.add({Instant{900000}, frame, true});  // one frame on each side of a full second
    report.bus_use.add({Instant{1100000}, frame, true});
    // The load of two frames in half a second: bits / (125000 bit/s x 0.5 s)
    EXPECT_DOUBLE_EQ(*report.mean_load(), 100.0 * 2.0 * (frame_bits(frame) + 3U) / 62500.0);
    EXPECT_DOUBLE_EQ(*report.highest_load(), *report.mean_load());
}

TEST(ConformBusUse, FullBusHasALoadOf100PerCent) {
    const Frame frame = parse_frame("605#4000100000000000", "test");
    const std::uint64_t bits = frame_bits(frame) + 3U;
    ConformReport report;
    report.bit_rate = 125000;
    report.time = milliseconds(3000);
    // Each frame takes bits x 8 us. A frame that ends just after the start of a second has most bits before it.
    for (std::uint64_t end = bits * 8U; end < 3000000U; end += bits * 8U) {
        report.bus_use.add({Instant{end}, frame, true});
    }
    EXPECT_GT(report.bus_use.busiest_second(), 125000U);
    EXPECT_EQ(*report.highest_load(), 100.0);
}

}  // namespace canproof::host::conform::test
