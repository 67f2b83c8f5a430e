// SPDX-License-Identifier: Apache-2.0
// Sampling, input filter, additional filters and latency of the AX060805 (manual, 3.2, 3.3, 5.1.2, 4.3.2, 4.3.3, 4.3.10
// to 4.3.12, 4.3.34), node 127.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Row = std::vector<int>;

class Ax060805Filters : public InclinometerTest {
  protected:
    void SetUp() override {
        InclinometerTest::SetUp();
        angle_digits(100);
        acceleration_digits(1000);
    }
    void set_filter(std::uint8_t angle, std::uint32_t type, std::uint32_t constant) {
        write(0x2050, angle, type, 1);
        write(0x2051, angle, constant, 2);
    }
    /// Applies each angle of `stands` as pitch for `period` ms. Returns the measured pitch after each, in hundredths of
    /// a degree.
    Row pitches(const std::vector<double>& stands, std::uint64_t period) {
        Row all;
        for (const double angle : stands) {
            turn(angle, 0.0);
            pass(period);
            all.push_back(pitch());
        }
        return all;
    }
};

}  // namespace

TEST_F(Ax060805Filters, SensorIsSampledEvery5ms) {
    verifies<req::INC_FILTER_001, req::INC_K_SAMPLE_PERIOD>();
    switch_filter_off();
    EXPECT_EQ(device->next_deadline().us, 5000U);
    pass(5);
    turn(10.0, 0.0);
    pass(4);
    EXPECT_EQ(pitch(), 0);
    pass(1);
    EXPECT_EQ(pitch(), 1000);
    turn(20.0, 0.0);
    pass(4);
    EXPECT_EQ(pitch(), 1000);
    pass(1);
    EXPECT_EQ(pitch(), 2000);
}

TEST_F(Ax060805Filters, FirstSampleIsTakenUnfilteredAtStart) {
    verifies<req::INC_FILTER_001, req::INC_FILTER_005>();
    turn(30.0, 0.0);
    power_on();
    EXPECT_EQ(pitch(), 30);
}

TEST_F(Ax060805Filters, StepResponseFollowsTheLowPassCoefficient) {
    verifies<req::INC_FILTER_002, req::INC_OD_2002, req::INC_OD_2003>();
    feel(1.0, 0.0, -1.0);
    pass(5);
    EXPECT_EQ(value(0x4000, 1), 145);  // 1 - exp(-2 pi 5 0.005) = 0.1454
    pass(5);
    EXPECT_EQ(value(0x4000, 1), 270);  // 1 - 0.85464^2 = 0.2696
    write(0x2003, 0, 50, 1);           // the filter continues from its present value
    EXPECT_EQ(value(0x4000, 1), 270);
    pass(5);
    EXPECT_EQ(value(0x4000, 1), 848);  // 1 - 0.7304 * 0.20788 = 0.8482
}

TEST_F(Ax060805Filters, InputFilterAccepts1To50Hz) {
    verifies<req::INC_FILTER_006, req::INC_OD_2003, req::INC_FILTER_002>();
    EXPECT_EQ(refusal(0x2003, 0, 0, 1), "06090032");
    EXPECT_EQ(refusal(0x2003, 0, 51, 1), "06090031");
    EXPECT_EQ(refusal(0x2003, 0, 50, 1), "");
    write(0x2003, 0, 1, 1);
    feel(1.0, 0.0, -1.0);
    pass(5);
    EXPECT_EQ(value(0x4000, 1), 31);  // 1 - exp(-2 pi 1 0.005) = 0.030928
}

TEST_F(Ax060805Filters, InputFilterSettlesTo95PercentWithin200msWithoutOvershoot) {
    verifies<req::INC_FILTER_003, req::INC_FILTER_007>();
    turn(30.0, 0.0);
    int last = 0;
    for (int ms = 5; ms <= 1000; ms += 5) {
        pass(5);
        const int now_at = pitch();
        EXPECT_GE(now_at, last);
        EXPECT_LE(now_at, 3000);
        EXPECT_TRUE(ms < 200 || now_at >= 2850) << ms;
        last = now_at;
    }
    EXPECT_EQ(last, 3000);
}

TEST_F(Ax060805Filters, AccelerationIsUnfilteredWhileTheInputFilterIsOff) {
    verifies<req::INC_FILTER_004, req::INC_OD_2002>();
    write(0x2003, 0, 1, 1);
    switch_filter_off();
    feel(1.0, 0.0, -1.0);
    pass(5);
    EXPECT_EQ(value(0x4000, 1), 1000);
    EXPECT_EQ(refusal(0x2002, 0, 2, 1), "06090031");
}

TEST_F(Ax060805Filters, InputFilterRestartsAfterAnAccelerometerError) {
    verifies<req::INC_FILTER_005>();
    inputs.accelerometer_fault = true;
    set_inputs();
    pass(20);
    inputs.accelerometer_fault = false;
    turn(30.0, 0.0);
    pass(5);
    EXPECT_EQ(pitch(), 3000);
}

TEST_F(Ax060805Filters, InputFilterContinuesFromItsPresentValueAtANewCutOffFrequency) {
    verifies<req::INC_FILTER_008>();
    turn(30.0, 0.0);
    pass(50);  // 10 samples at 5 Hz
    const int reached = pitch();
    EXPECT_LT(reached, 2500);  // 1 - exp(-2 pi * 5 Hz * 0.05 s) = 79 % of the step
    write(0x2003, 0, 1, 1);
    EXPECT_EQ(pitch(), reached);
    pass(5);
    // One sample at 1 Hz covers 1 - exp(-2 pi * 1 Hz * 0.005 s) = 3.09 % of the rest of the step.
    EXPECT_NEAR(pitch(), reached + 0.0309 * (3000 - reached), 10.0);
}

TEST_F(Ax060805Filters, AngleAveragesRestartAfterAnAccelerometerError) {
    verifies<req::INC_AVG_013>();
    switch_filter_off();
    set_filter(1, 1, 100);
    set_filter(2, 2, 100);
    pass(500);
    inputs.accelerometer_fault = true;
    set_inputs();
    pass(20);
    inputs.accelerometer_fault = false;
    turn(30.0, 0.0);
    pass(5);
    EXPECT_EQ(read(0x4020), 0U);
    EXPECT_EQ(pitch(), 3000);
    turn(60.0, 0.0);
    pass(10);
    EXPECT_EQ(pitch(), 4500);  // the mean of the two samples 30 and 60 degrees
    inputs.accelerometer_fault = true;
    set_inputs();
    pass(5);
    inputs.accelerometer_fault = false;
    turn(0.0, 40.0);
    pass(5);
    EXPECT_EQ(angles(), (Row{0, 4000, 4000}));  // pitch 0, roll 40: the mean without older samples, because the filter
                                                // has restarted
}

TEST_F(Ax060805Filters, FailedSensorFreezesTheAngleAverages) {
    verifies<req::INC_FV_007>();
    switch_filter_off();
    set_filter(1, 1, 4);
    pass(2);
    EXPECT_EQ(pitches({40.0}, 10), (Row{2000}));  // the mean of 0 and 40 degrees
    inputs.accelerometer_fault = true;
    set_inputs();
    pass(30);
    EXPECT_EQ(pitch(), 2000);  // a failed accelerometer adds no sample to the average
    write(0x2051, 1, 8, 2);
    EXPECT_EQ(pitch(), 2000);  // in the larger window are still only the samples 0 and 40
}

TEST_F(Ax060805Filters, MovingAverageIsTheMeanOfFourSamples) {
    verifies<req::INC_AVG_001, req::INC_T4, req::INC_OD_2050, req::INC_OD_2051, req::INC_OD_2052>();
    switch_filter_off();
    set_filter(1, 1, 4);
    pass(2);  // from here on, the angles change between two samples of the sensor and between two of the filter
    // The first sample, 0, was taken when the filter started.
    EXPECT_EQ(pitches({10.0, 20.0, 30.0, 40.0, 40.0}, 10), (Row{500, 1000, 1500, 2500, 3250}));
}

TEST_F(Ax060805Filters, RepeatingFilterGivesOneMeanPerBlockOfSamples) {
    verifies<req::INC_AVG_003, req::INC_AVG_011, req::INC_T4, req::INC_OD_2050>();
    switch_filter_off();
    set_filter(1, 2, 3);
    pass(2);
    // The blocks of three samples are 0, 3, 6 degrees, then 9, 12, 15 degrees.
    EXPECT_EQ(pitches({3.0, 6.0, 9.0, 12.0, 15.0}, 10), (Row{150, 300, 300, 300, 1200}));
}

TEST_F(Ax060805Filters, AllAdditionalFiltersUseTheSameFilterRate) {
    verifies<req::INC_AVG_004, req::INC_OD_2052>();
    switch_filter_off();
    set_filter(1, 1, 2);
    set_filter(2, 1, 2);
    write(0x2052, 0, 40, 2);
    pass(2);
    turn(20.0, 0.0);
    pass(37);
    EXPECT_EQ(pitch(), 0);
    pass(1);  // 40 ms after the write that set the filter rate
    EXPECT_EQ(pitch(), 1000);
    pass(39);
    EXPECT_EQ(pitch(), 1000);
    pass(1);
    EXPECT_EQ(pitch(), 2000);
    write(0x2052, 0, 1, 2);
    turn(0.0, 20.0);
    pass(7);
    EXPECT_EQ(roll(), 2000);
    EXPECT_EQ(refusal(0x2052, 0, 0, 2), "06090032");
    EXPECT_EQ(refusal(0x2052, 0, 60001, 2), "06090031");
    EXPECT_EQ(refusal(0x2052, 0, 60000, 2), "");
}

TEST_F(Ax060805Filters, FilterRateOf1msCountsEachSensorSampleFiveTimes) {
    verifies<req::INC_AVG_014>();
    switch_filter_off();
    set_filter(1, 1, 10);
    write(0x2052, 0, 1, 2);
    pass(5);
    turn(10.0, 0.0);
    pass(9);  // the sensor measures 10 degrees after 5 ms; then five of the ten filter samples have this value
    EXPECT_EQ(pitch(), 500);
}

TEST_F(Ax060805Filters, EachAngleHasItsOwnFilterTypeAndConstant) {
    verifies<req::INC_AVG_005, req::INC_OD_2050, req::INC_OD_2051>();
    switch_filter_off();
    set_filter(1, 1, 2);
    set_filter(2, 2, 4);
    pass(2);
    turn(20.0, 0.0);
    pass(10);
    EXPECT_EQ(angles(), (Row{1000, 0, 2000}));
    set_filter(3, 1, 4);
    turn(0.0, 40.0);
    pass(10);
    EXPECT_EQ(angles(), (Row{1000, 1333, 3000}));  // pitch (20 + 0) / 2, roll (0 + 0 + 40) / 3, gravity (20 + 40) / 2
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(refusal(0x2050, sub, 3, 1), "06090031");
        EXPECT_EQ(refusal(0x2051, sub, 0, 2), "06090032");
        EXPECT_EQ(refusal(0x2051, sub, 60001, 2), "06090031");
        EXPECT_EQ(refusal(0x2051, sub, 60000, 2), "");
    }
}

TEST_F(Ax060805Filters, FiltersAverageTheShortWayAcross180Degrees) {
    verifies<req::INC_AVG_006>();
    switch_filter_off();
    turn(0.0, 179.0);
    pass(5);
    set_filter(2, 1, 2);
    pass(2);
    turn(0.0, -179.0);
    pass(10);
    EXPECT_EQ(roll(), 18000);
    turn(0.0, -177.0);
    pass(10);
    EXPECT_EQ(roll(), -17800);
}

TEST_F(Ax060805Filters, AngleFilterRestartsAtANewFilterTypeFilterConstantOrFilterRate) {
    verifies<req::INC_AVG_007, req::INC_AVG_012, req::INC_AVG_015>();
    switch_filter_off();
    set_filter(1, 1, 100);
    pass(500);
    turn(30.0, 0.0);
    pass(10);
    EXPECT_LT(pitch(), 200);
    write(0x2051, 1, 100, 2);
    EXPECT_EQ(pitch(), 3000);
    turn(60.0, 0.0);
    pass(10);
    EXPECT_EQ(pitch(), 4500);
    write(0x2052, 0, 20, 2);
    EXPECT_EQ(pitch(), 6000);
    turn(0.0, 0.0);
    pass(20);
    EXPECT_EQ(pitch(), 3000);
    write(0x2050, 1, 0, 1);
    EXPECT_EQ(pitch(), 0);
    turn(45.0, 0.0);
    pass(5);
    EXPECT_EQ(pitch(), 4500);  // without a filter the angle follows each sample of the sensor
}

TEST_F(Ax060805Filters, WindowOf60000SamplesShowsHalfOfAStepAfter30000Samples) {
    verifies<req::INC_AVG_008>();
    switch_filter_off();
    set_filter(1, 1, 60000);
    write(0x2052, 0, 1, 2);
    turn(10.0, 0.0);
    pass(60000);
    EXPECT_NEAR(pitch(), 1000, 1);
    turn(20.0, 0.0);
    pass(30000);
    // The angle has done half of the step from 10 to 20 degrees. The filter keeps its samples as sums of 938 samples
    // (60,000 / 64). The tolerance is the share of one such sum: 10 degrees * 938 / 60,000 = 0.16 degrees.
    EXPECT_NEAR(pitch(), 1500, 16);
}

TEST_F(Ax060805Filters, FilterLatencyIsThatOfTheAngleWithTheSlowestFilter) {
    verifies<req::INC_LATENCY_001, req::INC_OD_4010>();
    EXPECT_EQ(read(0x4010), 32U);  // 1000 / (2 pi 5) = 31.83
    write(0x2003, 0, 50, 1);
    EXPECT_EQ(read(0x4010), 3U);  // 1000 / (2 pi 50) = 3.18
    write(0x2003, 0, 5, 1);
    set_filter(1, 1, 10);
    EXPECT_EQ(read(0x4010), 77U);  // 31.83 + 9 / 2 * 10
    set_filter(2, 2, 10);
    EXPECT_EQ(read(0x4010), 127U);  // 31.83 + 19 / 2 * 10
    switch_filter_off();
    EXPECT_EQ(read(0x4010), 95U);
    write(0x2052, 0, 30, 2);
    EXPECT_EQ(read(0x4010), 285U);
    set_filter(3, 2, 60000);
    write(0x2052, 0, 60000, 2);
    EXPECT_EQ(read(0x4010), 65535U);
    set_filter(3, 0, 1);
    set_filter(2, 0, 1);
    set_filter(1, 0, 1);
    EXPECT_EQ(read(0x4010), 0U);
    write(0x2052, 0, 30, 2);
    set_filter(3, 1, 11);
    EXPECT_EQ(read(0x4010), 150U);  // 10 / 2 * 30
}

TEST_F(Ax060805Filters, LateCallOfAdvanceRestartsTheSensorSamplePeriod) {
    verifies<req::INC_FILTER_001>();
    pass(5);
    now = now + milliseconds(52);  // at 57 ms: the samples due from 10 to 55 ms were missed
    device->advance(now);
    EXPECT_EQ(elapsed(now, device->next_deadline()).us, 5000U);
}

TEST_F(Ax060805Filters, SlightlyLateCallOfAdvanceShiftsNeitherSensorNorFilterSamples) {
    verifies<req::INC_FILTER_001, req::INC_AVG_004>();
    write(0x2052, 0, 7, 2);
    now = now + milliseconds(9);  // it is 9 ms now: the sample of the sensor was due at 5 ms, that of the additional
                                  // filters at 7 ms
    device->advance(now);
    EXPECT_EQ(device->next_deadline().us, 10000U);
    pass(1);
    EXPECT_EQ(device->next_deadline().us, 14000U);
}

TEST_F(Ax060805Filters, SampleThatIsDueBeforeAFrameIsTakenFirst) {
    verifies<req::INC_FILTER_001>();
    switch_filter_off();
    turn(10.0, 0.0);
    now = now + milliseconds(7);  // the device was not called since 0 ms
    EXPECT_EQ(pitch(), 1000);
    turn(20.0, 0.0);
    now = now + milliseconds(4);
    turn(30.0, 0.0);  // set at 11 ms, after the sensor's sample at 10 ms
    EXPECT_EQ(pitch(), 2000);
}

TEST_F(Ax060805Filters, NewMeasurementsAppearWithTheNextSample) {
    verifies<req::INC_FILTER_001, req::INC_FV_006, req::INC_GLOBAL_001, req::INC_GLOBAL_002>();
    write(0x2052, 0, 7, 2);
    inputs.sensor_temperature = 20.0F;
    inputs.supply_voltage = 12.0F;
    inputs.processor_temperature = 40.0F;
    set_inputs();
    pass(6);
    inputs.sensor_temperature = 60.0F;
    inputs.supply_voltage = 24.0F;
    inputs.processor_temperature = 80.0F;
    set_inputs();
    for (int ms = 6; ms < 10; ++ms) {  // at 7 ms the additional filters take their sample, but the sensor takes none
                                       // before 10 ms
        EXPECT_EQ(value(0x4060), 20) << ms;
        EXPECT_EQ(real(0x5020), 12.0F) << ms;
        EXPECT_EQ(real(0x5030), 40.0F) << ms;
        pass(1);
    }
    EXPECT_EQ(value(0x4060), 60);
    EXPECT_EQ(real(0x5020), 24.0F);
    EXPECT_EQ(real(0x5030), 80.0F);
}

}  // namespace canproof::test
