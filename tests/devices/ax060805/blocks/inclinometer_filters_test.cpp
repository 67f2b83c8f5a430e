// SPDX-License-Identifier: Apache-2.0
// Tests the low-pass filter, the moving average and the repeating filter of the AX060805 (manual, 3.2, 3.3 Table 4,
// 4.3.10 to 4.3.12, 5.1.2).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "devices/ax060805/firmware/angle_filter.hpp"
#include "devices/ax060805/firmware/low_pass.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax060805;

constexpr Duration period = milliseconds(5);

/// Returns the output of the filter after each sample.
std::vector<float> outputs(AngleFilter& filter, const std::vector<float>& samples) {
    std::vector<float> all;
    for (const float sample : samples) {
        filter.add(sample);
        all.push_back(filter.output());
    }
    return all;
}

AngleFilter filter_of(AngleFilterKind kind, std::uint16_t samples) {
    AngleFilter filter;
    filter.restart(kind, samples);
    return filter;
}

}  // namespace

TEST(LowPass, CoefficientIsOneMinusExpOfMinus2PiFT) {
    verifies<req::INC_FILTER_002>();
    EXPECT_NEAR(low_pass_coefficient(5.0F, period), 0.145364F, 1e-6F);   // 2 pi 5 0.005 = 0.157080
    EXPECT_NEAR(low_pass_coefficient(50.0F, period), 0.792120F, 1e-6F);  // 2 pi 50 0.005 = 1.570796
    EXPECT_NEAR(low_pass_coefficient(1.0F, period), 0.030928F, 1e-6F);   // 2 pi 1 0.005 = 0.031416
}

TEST(LowPass, OutputMovesByTheCoefficientTimesTheDifference) {
    verifies<req::INC_FILTER_002, req::INC_FILTER_005>();
    LowPass filter;
    filter.update({1.0F, -1.0F, 8.0F}, 0.5F);  // the first sample becomes the output unchanged
    const Vector3 second = filter.update({3.0F, -5.0F, 0.0F}, 0.5F);
    EXPECT_EQ(second.x, 2.0F);
    EXPECT_EQ(second.y, -3.0F);
    EXPECT_EQ(second.z, 4.0F);
    EXPECT_EQ(filter.update({3.0F, -5.0F, 0.0F}, 0.5F).x, 2.5F);
}

TEST(LowPass, CoefficientOf1LeavesSamplesUnchanged) {
    verifies<req::INC_FILTER_004>();
    LowPass filter;
    filter.update({1.0F, 0.0F, 0.0F}, 1.0F);
    EXPECT_EQ(filter.update({0.3F, 0.0F, 0.0F}, 1.0F).x, 0.3F);
}

TEST(LowPass, RestartTakesTheNextSampleUnfiltered) {
    verifies<req::INC_FILTER_005>();
    LowPass filter;
    filter.update({1.0F, 0.0F, 0.0F}, 0.1F);
    filter.restart();
    EXPECT_EQ(filter.update({-1.0F, 0.0F, 0.0F}, 0.1F).x, -1.0F);
}

TEST(LowPass, OutputAt5HzReaches95PercentAfterTwentySamplesWithoutOvershoot) {
    verifies<req::INC_FILTER_003, req::INC_FILTER_007>();
    LowPass filter;
    const float share = low_pass_coefficient(5.0F, period);
    filter.update({0.0F, 0.0F, 0.0F}, share);
    float last = 0.0F;
    for (int sample = 1; sample <= 40; ++sample) {
        const float now = filter.update({1.0F, 0.0F, 0.0F}, share).x;
        EXPECT_GE(now, last);
        EXPECT_LE(now, 1.0F);
        // After n samples exp(-0.15708 n) of the step remains: 0.0506 after 19 samples, 0.0432 after 20.
        EXPECT_EQ(now >= 0.95F, sample >= 20) << sample;
        last = now;
    }
}

TEST(LowPass, FilterDelayIsTheTimeConstant) {
    verifies<req::INC_LATENCY_001>();
    EXPECT_NEAR(low_pass_delay_ms(5.0F), 31.831F, 0.001F);  // 1000 / 31.4159
    EXPECT_NEAR(low_pass_delay_ms(50.0F), 3.1831F, 0.0001F);
}

TEST(AngleFilter, AngleWithoutAFilterIsTheLatestSample) {
    verifies<req::INC_AVG_007>();
    AngleFilter filter = filter_of(AngleFilterKind::none, 10);
    EXPECT_EQ(outputs(filter, {10.0F, -179.5F, 33.25F}), (std::vector<float>{10.0F, -179.5F, 33.25F}));
}

TEST(AngleFilter, MovingAverageIsTheMeanOfTheLatestSamples) {
    verifies<req::INC_AVG_001>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 4);
    EXPECT_EQ(outputs(filter, {0.0F, 10.0F, 20.0F, 30.0F, 40.0F, 40.0F}),
              (std::vector<float>{0.0F, 5.0F, 10.0F, 15.0F, 25.0F, 32.5F}));
}

TEST(AngleFilter, MovingAverageOfOneSampleIsThatSample) {
    verifies<req::INC_AVG_001>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 1);
    EXPECT_EQ(outputs(filter, {5.0F, -5.0F, 90.0F}), (std::vector<float>{5.0F, -5.0F, 90.0F}));
}

TEST(AngleFilter, RepeatingFilterGivesTheMeanOfABlockUntilTheNextBlockIsFull) {
    verifies<req::INC_AVG_003, req::INC_AVG_011>();
    AngleFilter filter = filter_of(AngleFilterKind::repeating, 3);
    EXPECT_EQ(outputs(filter, {3.0F, 6.0F, 9.0F, 12.0F, 15.0F, 18.0F, -90.0F}),
              (std::vector<float>{3.0F, 4.5F, 6.0F, 6.0F, 6.0F, 15.0F, 15.0F}));
}

TEST(AngleFilter, AverageTakesTheShortWayAcross180Degrees) {
    verifies<req::INC_AVG_006>();
    AngleFilter moving = filter_of(AngleFilterKind::moving_average, 2);
    EXPECT_EQ(outputs(moving, {179.0F, -179.0F, -177.0F}), (std::vector<float>{179.0F, 180.0F, -178.0F}));
    AngleFilter repeating = filter_of(AngleFilterKind::repeating, 2);
    EXPECT_EQ(outputs(repeating, {-170.0F, 160.0F}).back(), 175.0F);  // -170 equals 190
}

TEST(AngleFilter, AverageOfHalfATurnIsPlus180Degrees) {
    verifies<req::INC_AVG_006, req::INC_ANGLE_014>();
    AngleFilter one = filter_of(AngleFilterKind::moving_average, 1);
    EXPECT_EQ(outputs(one, {-180.0F, 180.0F}), (std::vector<float>{180.0F, 180.0F}));
    AngleFilter two = filter_of(AngleFilterKind::moving_average, 2);
    // 90 and -90 (that is, 270) degrees are half a turn apart; the filter gives the mean of 90 and 270
    EXPECT_EQ(outputs(two, {90.0F, -90.0F}).back(), 180.0F);
}

TEST(AngleFilter, AngleThatIsNotCircularIsAveragedAsANumber) {
    verifies<req::INC_AVG_018>();
    AngleFilter filter;
    filter.restart(AngleFilterKind::moving_average, 3, false);
    EXPECT_EQ(outputs(filter, {180.0F, 0.0F, 180.0F, 0.0F}), (std::vector<float>{180.0F, 90.0F, 120.0F, 60.0F}));
    filter.restart(AngleFilterKind::repeating, 2, false);
    EXPECT_EQ(outputs(filter, {90.0F, -90.0F}).back(), 0.0F);
}

TEST(AngleFilter, AverageOfAnEndlessTurnLosesNoAccuracy) {
    verifies<req::INC_AVG_006>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 3);
    for (int sample = 0; sample < 20000; ++sample) {
        const int turned = (100 * sample) % 360;
        filter.add(static_cast<float>(turned > 180 ? turned - 360 : turned));
        // the last three samples are 100 degrees apart, so their mean is the middle one
        const int middle = (100 * (sample + 359)) % 360;
        const float expected = static_cast<float>(middle > 180 ? middle - 360 : middle);
        if (sample >= 2) {
            ASSERT_NEAR(filter.output(), expected, 2e-5F) << sample;
        }
    }
}

TEST(AngleFilter, RestartDropsEarlierSamples) {
    verifies<req::INC_AVG_012>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 4);
    outputs(filter, {100.0F, 100.0F, 100.0F});
    filter.restart(AngleFilterKind::moving_average, 4);
    EXPECT_EQ(outputs(filter, {-20.0F, -10.0F}), (std::vector<float>{-20.0F, -15.0F}));
    for (int round = 0; round < 2; ++round) {  // the second restart comes after a complete block
        filter.restart(AngleFilterKind::repeating, 2);
        EXPECT_EQ(outputs(filter, {8.0F, 10.0F, 50.0F}), (std::vector<float>{8.0F, 9.0F, 9.0F}));
    }
}

TEST(AngleFilter, WindowsOf63And64SamplesDropTheSampleBeforeTheWindow) {
    verifies<req::INC_AVG_001, req::INC_AVG_002>();
    for (const int samples : {63, 64}) {
        AngleFilter filter = filter_of(AngleFilterKind::moving_average, static_cast<std::uint16_t>(samples));
        filter.add(static_cast<float>(samples));
        for (int sample = 1; sample < samples; ++sample) {
            filter.add(0.0F);
        }
        EXPECT_EQ(filter.output(), 1.0F) << samples;
        filter.add(0.0F);
        EXPECT_EQ(filter.output(), 0.0F) << samples;
    }
}

TEST(AngleFilter, RoundingRemaindersOfALongWindowAreNotLost) {
    verifies<req::INC_AVG_008>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 3200);  // 64 runs of 50 samples
    for (int sample = 0; sample < 3200; ++sample) {
        filter.add(sample % 50 == 0 ? 0.000049F : 0.0F);
    }
    EXPECT_EQ(filter.output(), 0.000001F);  // 64 * 49 / 3200 = 0.98 millionths of a degree; the nearest value is 1
}

TEST(AngleFilter, LongWindowsKeepAConstantAngle) {
    verifies<req::INC_AVG_009>();
    for (const int samples : {65, 128, 1000}) {
        AngleFilter filter = filter_of(AngleFilterKind::moving_average, static_cast<std::uint16_t>(samples));
        for (int sample = 0; sample < 2 * samples; ++sample) {
            filter.add(123.456F);
            EXPECT_NEAR(filter.output(), 123.456F, 1e-5F) << samples << ", " << sample;
        }
    }
}

TEST(AngleFilter, LongestWindowKeepsAConstantAngle) {
    verifies<req::INC_AVG_009>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 60000);
    for (int sample = 0; sample < 120000; ++sample) {
        filter.add(123.456F);
    }
    EXPECT_NEAR(filter.output(), 123.456F, 1e-5F);
}

TEST(AngleFilter, AverageOver128SamplesOfARampErrsByAtMostTwoSampleSteps) {
    verifies<req::INC_AVG_010>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 128);  // with this window the filter adds up groups
                                                                           // of two samples
    for (int sample = 0; sample < 1000; ++sample) {
        filter.add(0.01F * static_cast<float>(sample));
        if (sample >= 127) {
            // the output is the mean of the samples from n - 127 to n
            ASSERT_NEAR(filter.output(), 0.01F * (static_cast<float>(sample) - 63.5F), 0.02F) << sample;
        }
    }
}

TEST(AngleFilter, AverageOfAnEndlessTurnWithALongWindowLosesNoAccuracy) {
    verifies<req::INC_AVG_010, req::INC_AVG_006>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 1000);  // groups of 16 samples
    const int step = 7;  // degrees per sample: at sample 3292, which does not begin a group, the sum exceeds 64 turns
                         // (23,040 degrees)
    for (int sample = 0; sample < 8000; ++sample) {
        filter.add(std::remainder(static_cast<float>(step * sample), 360.0F));
        if (sample >= 999) {
            // The exact mean is that of the samples n - 999 to n. Only part of the oldest group of 16 samples is in the
            // window, so the mean errs by at most 8 samples.
            const float mean = static_cast<float>(step) * (static_cast<float>(sample) - 499.5F);
            ASSERT_NEAR(std::remainder(filter.output() - mean, 360.0F), 0.0F, 1.0F) << sample;
        }
    }
}

TEST(AngleFilter, WindowOf60000SamplesShowsHalfOfAStepAfter30000Samples) {
    verifies<req::INC_AVG_001, req::INC_AVG_008>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 60000);
    for (int sample = 0; sample < 60000; ++sample) {
        filter.add(0.0F);
    }
    for (int sample = 0; sample < 30000; ++sample) {
        filter.add(10.0F);
    }
    // tolerance: the filter adds up groups of 938 samples, and one group has the share 938 / 60,000 of 10 degrees
    EXPECT_NEAR(filter.output(), 5.0F, 0.16F);
    for (int sample = 0; sample < 30000; ++sample) {
        filter.add(10.0F);
    }
    EXPECT_NEAR(filter.output(), 10.0F, 0.16F);
}

TEST(AngleFilter, OldestGroupOfSamplesIsWeightedByItsSamplesInsideTheWindow) {
    verifies<req::INC_AVG_016>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 65);  // groups of 2 samples
    filter.add(6.5F);
    for (int sample = 0; sample < 65; ++sample) {
        filter.add(0.0F);
    }
    // The window contains 64 samples of 0 and one of the two samples of the first group, whose mean is 6.5 / 2. So the
    // output is 6.5 / 2 / 65 = 0.05.
    EXPECT_EQ(filter.output(), 0.05F);
    filter.add(0.0F);
    filter.add(0.0F);
    EXPECT_EQ(filter.output(), 0.0F);
}

TEST(AngleFilter, ShareOfTheOldestGroupCountsToTheMillionthOfADegree) {
    verifies<req::INC_AVG_016>();
    // A window of 60000 samples has groups of 938. After 64 groups it contains 63 of them, which are 59094 samples, and
    // 906 samples of the oldest. The mean rounds to a millionth of a degree from a sum of 30000 millionths on.
    struct Case {
        int oldest;  ///< sum of the oldest group, in millionths of a degree
        int others;  ///< sum of the other groups
        float mean;
    };
    const std::array<Case, 4> cases{{
        {1875, 28195, 0.000001F},  // 1875 * 906 / 938 = 1811.03, and 28195 more are 30006
        {1875, 28180, 0.0F},       // 1811.03 and 28180 are 29991
        {906, 29130, 0.000001F},   // 906 * 906 / 938 = 875.09, and 29130 more are 30005
        {906, 29110, 0.0F},        // 875.09 and 29110 are 29985
    }};
    for (const Case& each : cases) {
        AngleFilter filter = filter_of(AngleFilterKind::moving_average, 60000);
        for (int sample = 0; sample < 938; ++sample) {
            // The sum is spread evenly, in whole millionths.
            const int millionths = (each.oldest * (sample + 1)) / 938 - (each.oldest * sample) / 938;
            filter.add(static_cast<float>(millionths) * 0.000001F);
        }
        for (int sample = 0; sample < 63 * 938; ++sample) {
            filter.add(sample < each.others ? 0.000001F : 0.0F);
        }
        EXPECT_EQ(filter.output(), each.mean) << each.oldest << ", " << each.others;
    }
}

/// A step from 0 to 90 degrees at the beginning of a group reaches the output fully with sample N, and not before. With
/// fewer or shorter groups, the window has too few samples.
TEST(AngleFilter, SumsOfAtMost64GroupsContainEverySampleOfTheWindow) {
    verifies<req::INC_AVG_017>();
    for (const int samples : {65, 127, 128, 129, 1000, 59999, 60000}) {
        AngleFilter filter = filter_of(AngleFilterKind::moving_average, static_cast<std::uint16_t>(samples));
        const int group = (samples + 63) / 64;
        for (int sample = 0; sample < 64 * group; ++sample) {
            filter.add(0.0F);
        }
        for (int sample = 0; sample < samples; ++sample) {
            ASSERT_LT(filter.output(), 90.0F) << samples << ", after " << sample << " samples";
            filter.add(90.0F);
        }
        EXPECT_EQ(filter.output(), 90.0F) << samples;
    }
}

TEST(AngleFilter, FilterOfAnyWindowNeedsAtMost592Bytes) {
    verifies<req::INC_AVG_017>();
    EXPECT_LE(sizeof(AngleFilter), 64U * 8U + 80U);
}

TEST(AngleFilter, FilterDelayIsHalfTheWindow) {
    verifies<req::INC_LATENCY_001>();
    EXPECT_EQ(angle_filter_delay_ms(AngleFilterKind::none, 10, 10), 0.0F);
    EXPECT_EQ(angle_filter_delay_ms(AngleFilterKind::moving_average, 10, 10), 45.0F);
    EXPECT_EQ(angle_filter_delay_ms(AngleFilterKind::repeating, 10, 10), 95.0F);
    EXPECT_EQ(angle_filter_delay_ms(AngleFilterKind::moving_average, 1, 1000), 0.0F);
}

TEST(AngleFilter, WindowOfZeroSamplesCountsAsOneSample) {
    verifies<req::INC_AVG_001, req::INC_LATENCY_001>();
    AngleFilter filter = filter_of(AngleFilterKind::moving_average, 0);
    EXPECT_EQ(outputs(filter, {10.0F, 20.0F, -5.0F}), (std::vector<float>{10.0F, 20.0F, -5.0F}));
    EXPECT_EQ(angle_filter_delay_ms(AngleFilterKind::repeating, 0, 100), 50.0F);  // (2 * 1 - 1) * 100 / 2
    EXPECT_EQ(angle_filter_delay_ms(AngleFilterKind::moving_average, 0, 100), 0.0F);
}

TEST(AngleFilter, EndlessTurnInEitherDirectionIsAveraged) {
    verifies<req::INC_AVG_006>();
    for (const float step : {120.0F, -120.0F}) {
        AngleFilter filter = filter_of(AngleFilterKind::moving_average, 3);
        float angle = 0.0F;
        for (int sample = 0; sample < 20000; ++sample) {  // 20,000 samples of a third of a turn: 6,666 and two thirds
                                                          // turns in all
            angle += step;
            angle = angle > 180.0F ? angle - 360.0F : angle;
            angle = angle < -180.0F ? angle + 360.0F : angle;
            filter.add(angle);
        }
        // Three samples are each a third of a turn from the next, so their mean is the middle one.
        const float middle = angle - step < -180.0F ? angle - step + 360.0F : angle - step;
        EXPECT_NEAR(filter.output(), middle > 180.0F ? middle - 360.0F : middle, 1e-4F);
    }
}

/// The filter must remove whole turns. Otherwise, after 1,400,000 samples of a third of a turn, the sum of a block of
/// 60,000 would be 1.4e6 * 1.2e8 * 6e4 = 1e19 microdegrees, which exceeds 63 bits.
TEST(AngleFilter, MeanOfABlockOf60000SamplesIsRightAfter480000Turns) {
    verifies<req::INC_AVG_003, req::INC_AVG_006>();
    for (const float side : {1.0F, -1.0F}) {
        AngleFilter filter = filter_of(AngleFilterKind::repeating, 60000U);
        const std::array<float, 3U> stands{{0.0F, 120.0F * side, -120.0F * side}};
        for (std::size_t i = 0U; i < 1'440'000U; ++i) {  // 24 blocks of 60,000 samples
            filter.add(stands[i % 3U]);
        }
        // The mean of 0, 120, 240, … 59,999 * 120 is 3,599,940 degrees, 10,000 turns minus 60 degrees.
        EXPECT_EQ(filter.output(), -60.0F * side);
    }
}

TEST(AngleFilter, HalfAMicrodegreeIsRoundedAwayFromZero) {
    verifies<req::INC_AVG_001>();
    for (const float side : {1.0F, -1.0F}) {
        AngleFilter filter = filter_of(AngleFilterKind::moving_average, 2U);
        filter.add(0.0F);
        filter.add(side * 1.0e-6F);
        EXPECT_EQ(filter.output(), side * 1.0e-6F);
        AngleFilter repeating = filter_of(AngleFilterKind::repeating, 4U);
        for (const std::size_t block : {1U, 2U}) {
            repeating.add(0.0F);
            repeating.add(0.0F);
            repeating.add(0.0F);
            repeating.add(side * 1.0e-6F);  // the mean is a quarter of a microdegree
            EXPECT_EQ(repeating.output(), 0.0F) << block;
        }
    }
}

}  // namespace canproof::test
