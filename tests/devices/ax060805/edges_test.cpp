// SPDX-License-Identifier: Apache-2.0
// Checks the constants of the AX060805 by the device's behaviour just below and just above each constant, within a
// thousandth of the constant.
#include <limits>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// The input filter is off; angles are Euler angles in thousandths of a degree.
class InclinometerEdges : public InclinometerTest {
  protected:
    void SetUp() override {
        InclinometerTest::SetUp();
        switch_filter_off();
        use_euler_angles();
        angle_digits(1000);
    }
    std::uint32_t merit_at(double x, double y, double z) {
        feel(x, y, z);
        pass(5);
        return read(0x4020);
    }
    /// Returns the figure of merit while the X axis is `degrees` from the vertical and the Y axis takes the rest of
    /// gravity.
    std::uint32_t merit_beside_the_vertical(double degrees) {
        turn(90.0 - degrees, 90.0);
        pass(5);
        return read(0x4020);
    }
    std::uint32_t merit_when_warm(float degrees) {
        inputs.sensor_temperature = degrees;
        set_inputs();
        pass(5);
        return read(0x4020);
    }
};

}  // namespace

TEST_F(InclinometerEdges, GimbalLockBeginsOneDegreeFromTheVertical) {
    verifies<req::INC_K_GIMBAL_LOCK, req::INC_FOM_001, req::INC_INSTALL_005>();
    EXPECT_EQ(merit_beside_the_vertical(0.9995), 1U);
    EXPECT_EQ(refusal(0x2300, 0, 1, 1), "08000022");
    EXPECT_EQ(merit_beside_the_vertical(1.0005), 0U);
    EXPECT_EQ(refusal(0x2300, 0, 1, 1), "");
}

TEST_F(InclinometerEdges, AutoNullNeedsAtLeastATenthOfG) {
    verifies<req::INC_INSTALL_005>();
    angles_at(0.0, 0.0, 0.0998);
    EXPECT_EQ(refusal(0x2300, 0, 1, 1), "08000022");
    angles_at(0.0, 0.0, 0.1002);
    EXPECT_EQ(refusal(0x2300, 0, 1, 1), "");
}

TEST_F(InclinometerEdges, EulerRollIsFrozenWithin0Point00005DegreesOfTheVertical) {
    verifies<req::INC_K_EXACT_ANGLE, req::INC_ANGLE_008, req::INC_ANGLE_016>();
    turn(60.0, 40.0);
    pass(5);
    // While the X axis is within 0.00005 degrees of the vertical, the roll keeps its last value. The sine of this angle
    // is 8.7266e-7.
    EXPECT_EQ(angles_at(1.0, 8.722e-7, 0.0)[1], 32767);  // 40 degrees are 40,000 thousandths: clamped to 16 bits
    angle_digits(100);
    EXPECT_EQ(angles_at(1.0, 8.722e-7, 0.0)[1], 4000);   // in hundredths: the roll is still 40 degrees
    EXPECT_EQ(angles_at(1.0, 8.731e-7, 0.0)[1], -9000);  // the roll that the formula gives: -90 degrees
}

TEST_F(InclinometerEdges, FigureOfMeritIs1BelowATenthOfG) {
    verifies<req::INC_K_LEAST_GRAVITY, req::INC_ANGLE_011>();
    EXPECT_EQ(merit_at(0.0, 0.0, -0.10005), 0U);
    EXPECT_EQ(merit_at(0.0, 0.0, -0.09995), 1U);
    EXPECT_EQ(merit_at(0.0, 0.10005, 0.0), 0U);
    EXPECT_EQ(roll(), -32768);  // -90 degrees are -90,000 thousandths: clamped to 16 bits
    EXPECT_EQ(merit_at(0.0, 0.0, -0.09995), 1U);
    EXPECT_EQ(roll(), -32768);  // the roll is kept from the last direction with enough gravity
}

TEST_F(InclinometerEdges, SensorMeasuresUpTo16gOnEachAxis) {
    verifies<req::INC_K_SENSOR_RANGE, req::INC_ERR_006>();
    for (const double sign : {1.0, -1.0}) {
        EXPECT_EQ(merit_at(16.0 * sign, 1.0, -1.0), 0U);
        EXPECT_EQ(merit_at(16.001 * sign, 1.0, -1.0), 2U);
        EXPECT_EQ(merit_at(1.0, 16.0 * sign, -1.0), 0U);
        EXPECT_EQ(merit_at(1.0, 16.001 * sign, -1.0), 2U);
        EXPECT_EQ(merit_at(1.0, 1.0, 16.0 * sign), 0U);
        EXPECT_EQ(merit_at(1.0, 1.0, 16.001 * sign), 2U);
    }
}

TEST_F(InclinometerEdges, SensorTemperatureFaultBeginsBelowMinus40AndAbove125Degrees) {
    verifies<req::INC_K_TEMPERATURE_LOW, req::INC_K_TEMPERATURE_HIGH, req::INC_ERR_005>();
    EXPECT_EQ(merit_when_warm(125.0F), 0U);
    EXPECT_EQ(read(0x1001), 0U);
    EXPECT_EQ(merit_when_warm(125.01F), 1U);
    EXPECT_EQ(read(0x1003, 1), 0x4200U);
    EXPECT_EQ(merit_when_warm(-40.0F), 0U);
    EXPECT_EQ(read(0x1001), 0U);
    EXPECT_EQ(merit_when_warm(-40.01F), 1U);
    EXPECT_EQ(read(0x1003, 1), 0x4200U);
}

TEST_F(InclinometerEdges, SamplePeriodIsFiveMillisecondsToTheMicrosecond) {
    verifies<req::INC_K_SAMPLE_PERIOD, req::INC_FILTER_001>();
    pass(5);
    const Instant sampled = now;
    acceleration_digits(1000);
    feel(0.5, 0.0, -1.0);
    now = Instant{sampled.us + 4999};
    device->advance(now);
    EXPECT_EQ(accelerations()[0], 0);
    now = Instant{sampled.us + 5000};
    device->advance(now);
    EXPECT_EQ(accelerations()[0], 500);
}

TEST_F(InclinometerEdges, FilterLatencyIsRightForTheGreatestFilterConstantAndFilterRate) {
    verifies<req::INC_LATENCY_001, req::INC_OD_4010>();
    switch_filter_off();
    write(0x2052, 0, 1, 2);
    write(0x2051, 2, 60000, 2);
    write(0x2050, 2, 1, 1);
    EXPECT_EQ(read(0x4010), 30000U);  // (60,000 - 1) / 2 * 1 ms = 29,999.5 ms
    write(0x2050, 2, 2, 1);
    EXPECT_EQ(read(0x4010), 60000U);  // (2 * 60,000 - 1) / 2 * 1 ms = 59,999.5 ms
    write(0x2050, 2, 1, 1);
    write(0x2051, 2, 2, 2);
    write(0x2052, 0, 60000, 2);
    EXPECT_EQ(read(0x4010), 30000U);  // (2 - 1) / 2 * 60,000 ms
}

TEST_F(InclinometerEdges, AdditionalFiltersCanTakeOneSamplePerMinute) {
    verifies<req::INC_AVG_004, req::INC_OD_2052>();
    switch_filter_off();
    angle_digits(100);
    write(0x2051, 1, 2, 2);
    write(0x2050, 1, 1, 1);      // pitch: a moving average of two samples
    write(0x2052, 0, 60000, 2);  // at this write the filter restarts and takes its first sample
    turn(20.0, 0.0);
    pass(59999);
    EXPECT_EQ(pitch(), 0);
    pass(1);
    EXPECT_EQ(pitch(), 1000);  // the mean of 0 and 20 degrees, in hundredths
    pass(59999);
    EXPECT_EQ(pitch(), 1000);
    pass(1);
    EXPECT_EQ(pitch(), 2000);
}

TEST_F(InclinometerEdges, SupplyAndProcessorTemperatureAreShownUpToTheEndsOfTheirRanges) {
    verifies<req::INC_GLOBAL_001, req::INC_GLOBAL_004, req::INC_GLOBAL_002, req::INC_GLOBAL_005>();
    const auto shown = [this](float supply, float temperature) {
        inputs.supply_voltage = supply;
        inputs.processor_temperature = temperature;
        set_inputs();
        pass(5);
        return std::pair{real(0x5020), real(0x5030)};
    };
    EXPECT_EQ(shown(70.0F, 150.0F), (std::pair{70.0F, 150.0F}));
    EXPECT_EQ(shown(70.01F, 150.01F), (std::pair{70.0F, 150.0F}));
    EXPECT_EQ(shown(0.0F, -50.0F), (std::pair{0.0F, -50.0F}));
    EXPECT_EQ(shown(-0.01F, -50.01F), (std::pair{0.0F, -50.0F}));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(shown(12.0F, nan), (std::pair{12.0F, -50.0F}));
    EXPECT_EQ(shown(nan, 20.0F), (std::pair{12.0F, 20.0F}));
}

}  // namespace canproof::test
