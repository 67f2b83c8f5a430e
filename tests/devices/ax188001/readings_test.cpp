// SPDX-License-Identifier: Apache-2.0
// Tests the readings of the voltages at the terminals: their times, the gains, the steps of the converter, and the
// rejection of mains hum (AX188001 manual, 1.1, 3.3).
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001Values = TcsTest;

}  // namespace

TEST_F(Ax188001Values, VoltageThatNeedsTheLowestGainIsReadDuringBootUp) {
    verifies<req::TCS_IN_001>();
    inputs.tc_microvolts[0] = 57000.0F;
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_NEAR(static_cast<double>(read(0x2010, 1).value), 57000.0 + 1277.0, 3.0);  // type J has 1.277 mV at 25 degC
}

TEST_F(Ax188001Values, ThermocoupleInputsAreReadEvery165Milliseconds) {
    verifies<req::TCS_IN_015, req::TCS_K_UPDATE_PERIOD, req::TCS_IN_021>();
    heat(1, 100.0);
    pass(164);
    EXPECT_EQ(process_value(1), 4768);
    pass(1);
    EXPECT_EQ(process_value(1), 5968);
    heat(1, 50.0);
    pass(164);
    EXPECT_EQ(process_value(1), 5968);
    pass(1);
    EXPECT_EQ(process_value(1), 50 * 16 + 4368);
}

TEST_F(Ax188001Values, ThermocoupleTypeJIsReadToWithin0Point014DegreesAtTheHighestGain) {
    verifies<req::TCS_IN_002, req::TCS_K_CODES, req::TCS_T_GAIN>();
    // Half a step of 0.596 uV is 0.006 degC with the 50 uV/K of type J.
    for (double celsius = -200.0; celsius < 330.0; celsius += 17.3) {
        heat(1, celsius);
        settle();
        ASSERT_NEAR(static_cast<double>(field_value(1).real()), celsius, celsius < -100.0 ? 0.014 : 0.0075) << celsius;
    }
}

TEST_F(Ax188001Values, StepOfTheConverterIsFullScaleDividedBy32768) {
    verifies<req::TCS_K_CODES, req::TCS_IN_002>();
    write(0x2000, 1, 1, 0);
    // Steps of 19531.25 / 32768 = 0.596046 uV: 25187 of them are 15012.62 uV, 25180 are 15008.45 uV.
    microvolts(1, 15012.4);
    read_once();
    EXPECT_EQ(read(0x2010, 1).value, 15013U);
    microvolts(1, 15008.7);
    read_once();
    EXPECT_EQ(read(0x2010, 1).value, 15008U);
}

TEST_F(Ax188001Values, JumpTo60MillivoltsIsReadWithin1500Milliseconds) {
    verifies<req::TCS_IN_003, req::TCS_IN_004, req::TCS_IN_016, req::TCS_IN_005, req::TCS_K_SETTLING,
             req::TCS_K_GAIN_BACK, req::TCS_S_ADC_GAIN, req::TCS_T_GAIN, req::TCS_IN_022>();
    write(0x2000, 1, 1, 0);
    microvolts(1, 60000.0);
    pass(4 * 165);
    EXPECT_EQ(device->outputs().tc_gain[0], 64);  // the first of two gain changes: 60 mV exceeds 19.53 mV (gain 128),
                                                  // and then 39.06 mV (gain 64)
    EXPECT_EQ(read(0x2010, 1).value, 0U);
    pass(5 * 165);
    EXPECT_NEAR(read(0x2010, 1).value, 60000, 2);
    EXPECT_EQ(device->outputs().tc_gain[0], 32);
    microvolts(1, 17578.5);  // a little above 90 % of the full scale 19531.25 uV
    read_once();
    EXPECT_NEAR(read(0x2010, 1).value, 17578, 3);
    EXPECT_EQ(device->outputs().tc_gain[0], 64);
    microvolts(1, 100.0);
    pass(3 * 165);
    EXPECT_NEAR(read(0x2010, 1).value, 17578, 3);
    read_once();
    EXPECT_NEAR(read(0x2010, 1).value, 100, 1);
    EXPECT_EQ(device->outputs().tc_gain[0], 128);
    EXPECT_EQ(device->outputs().tc_gain[1], 128);
}

TEST_F(Ax188001Values, EachOfTheThreeGainsIsUsedUpToItsFullScale) {
    verifies<req::TCS_T_GAIN, req::TCS_IN_003, req::TCS_IN_004, req::TCS_K_GAIN_BACK, req::TCS_IN_006>();
    write(0x2000, 1, 1, 0);
    const auto gain_at = [&](double uv) {
        microvolts(1, uv);
        settle();
        return static_cast<int>(device->outputs().tc_gain[0]);
    };
    EXPECT_EQ(gain_at(19531.0), 128);  // the full scale is 19531.25 uV
    EXPECT_EQ(gain_at(19531.5), 64);
    EXPECT_EQ(gain_at(39062.0), 64);  // the full scale is 39062.5 uV
    EXPECT_EQ(gain_at(39063.0), 32);
    EXPECT_EQ(gain_at(78124.0), 32);  // the full scale is 78125 uV
    EXPECT_NEAR(read(0x2010, 1).value, 78124, 2);
    EXPECT_EQ(gain_at(78126.0), 32);
    EXPECT_EQ(process_value(1), -512);
    EXPECT_EQ(gain_at(35157.0), 32);  // 90 % of 39062.5 is 35156.25
    EXPECT_EQ(gain_at(35156.0), 64);
    EXPECT_EQ(gain_at(17579.0), 64);  // 90 % of 19531.25 is 17578.125
    EXPECT_EQ(gain_at(17578.0), 128);
    EXPECT_EQ(gain_at(-39063.0), 32);
}

TEST_F(Ax188001Values, MainsHumIsRejectedAtTheSelectedFrequency) {
    verifies<req::TCS_IN_007, req::TCS_T_REJECTION, req::TCS_OD_2020, req::TCS_S_HUM, req::TCS_S_MAINS,
             req::TCS_S_ADC_FILTER, req::TCS_S_MICROVOLTS, req::TCS_IN_023>();
    write(0x2000, 1, 1, 0);
    inputs.tc_hum[0] = 1000000.0F;  // hum of 1 V; a rejection of 110 dB leaves 3.16 uV
    const auto swing = [&] {
        settle();
        const auto first = static_cast<std::int32_t>(read(0x2010, 1).value);
        read_once();
        return std::abs(static_cast<std::int32_t>(read(0x2010, 1).value) - first);
    };
    inputs.mains_frequency = 60;
    set_inputs();
    EXPECT_EQ(device->outputs().adc_filter, 60);
    EXPECT_NEAR(swing(), 6, 1);
    inputs.mains_frequency = 50;
    set_inputs();
    EXPECT_NEAR(swing(), 2 * 1330, 3);  // a rejection of 57.5 dB leaves 1330 uV of 1 V; the hum has opposite signs in
                                        // two readings
    EXPECT_EQ(write(0x2020, 0, 1, 50), 0U);
    EXPECT_EQ(device->outputs().adc_filter, 50);
    EXPECT_NEAR(swing(), 6, 1);
    inputs.mains_frequency = 60;
    set_inputs();
    EXPECT_NEAR(swing(), 2 * 590, 3);  // a rejection of 64.6 dB leaves 590 uV of 1 V
    inputs.mains_frequency = 0;
    set_inputs();
    EXPECT_EQ(swing(), 0);
    namespace table = generated::ax188001::hum_rejection;
    for (const auto filter : {table::FilterHz::hz_50, table::FilterHz::hz_60}) {
        ASSERT_NE(table::find(filter, table::MainsHz::none), nullptr);
        EXPECT_EQ(table::find(filter, table::MainsHz::none)->left, 0.0F);
    }
}

TEST_F(Ax188001Values, MainsHumIsAddedToOneReadingAndSubtractedFromTheNext) {
    verifies<req::TCS_IN_001, req::TCS_IN_015, req::TCS_IN_023>();
    inputs.tc_hum[0] = 1000000.0F;
    inputs.mains_frequency = 50;  // a rejection of 57.5 dB leaves 1.33 mV of 1 V of hum
    power_on();
    // Type J has 1277 uV at the 25 degC of the cold junction. Power-on makes nine conversions, in which the hum is
    // added and subtracted in turn: added in the first, and so in the ninth too.
    EXPECT_NEAR(static_cast<std::int32_t>(read(0x2010, 1).value), 1277 + 1330, 3);
    read_once();
    EXPECT_NEAR(static_cast<std::int32_t>(read(0x2010, 1).value), 1277 - 1330, 3);
}

TEST_F(Ax188001Values, FilterAccepts50And60HertzOnly) {
    verifies<req::TCS_IN_008, req::TCS_IN_017, req::TCS_OD_2020>();
    EXPECT_EQ(read(0x2020).value, 60U);
    for (const std::uint32_t hz : {0U, 49U, 51U, 55U, 59U, 61U, 255U}) {
        EXPECT_EQ(write(0x2020, 0, 1, hz), out_of_range) << hz;
    }
    microvolts(1, 1000.0);
    EXPECT_EQ(write(0x2020, 0, 1, 50), 0U);
    pass(3 * 165);
    EXPECT_EQ(process_value(1), 4768);  // after the change of the filter, the fifth reading is the first valid one
    pass(165);
    EXPECT_NE(process_value(1), 4768);
}

TEST_F(Ax188001Values, LateCallOfAdvancePerformsUpToEightMissedReadings) {
    verifies<req::TCS_IN_015>();
    write(0x2000, 1, 1, 0);
    microvolts(1, 60000.0);  // with two gain changes, only the ninth reading shows this voltage
    now = now + milliseconds(9 * period_ms);
    device->advance(now);
    EXPECT_EQ(device->outputs().tc_gain[0], 32);
    EXPECT_EQ(read(0x2010, 1).value, 0U);
    read_once();
    EXPECT_NEAR(read(0x2010, 1).value, 60000, 2);
}

TEST_F(Ax188001Values, NextReadingAfterAVeryLateCallOfAdvanceIsOnePeriodLater) {
    verifies<req::TCS_IN_015>();
    pass(period_ms);
    now = now + milliseconds(100 * period_ms);
    device->advance(now);
    EXPECT_EQ(device->next_deadline().us, (now + milliseconds(period_ms)).us);
}

}  // namespace canproof::test
