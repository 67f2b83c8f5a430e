// SPDX-License-Identifier: Apache-2.0
// Tests the converter with its gains 128, 64 and 32 (AX188001 manual, 1.1). With a reference of 2.5 V, the gains have
// full scales of 19531.25, 39062.5 and 78125 uV.
#include "devices/ax188001/firmware/gain_ranging.hpp"

#include <gtest/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

constexpr ConverterCircuit circuit{{{{128, 19531.25}, {64, 39062.5}, {32, 78125.0}}}, 32768.0, 0.9, 4};

class Converter : public testing::Test {
  protected:
    void convert(double uv, int times = 1) {
        for (int i = 0; i < times; ++i) {
            adc.convert(uv, circuit);
        }
    }
    GainRanging adc;
};

}  // namespace

TEST_F(Converter, ReadingIsRoundedToTheStepOfTheGain) {
    verifies<req::TCS_IN_002>();
    convert(1000.0);  // 1000 / 0.596046 = 1677.72: step 1678 = 1000.17 uV
    EXPECT_NEAR(adc.microvolts(), 1678 * 19531.25 / 32768, 1e-9);
    convert(-0.29);  // 0.29 uV is less than half a step of 0.596 uV: rounded to 0
    EXPECT_EQ(adc.microvolts(), 0.0);
    convert(-0.31);
    EXPECT_NEAR(adc.microvolts(), -19531.25 / 32768, 1e-9);
}

TEST_F(Converter, AfterOverdriveTheFourthConversionAtTheLowerGainGivesTheVoltage) {
    verifies<req::TCS_IN_003, req::TCS_IN_022>();
    convert(10000.0);
    const double before = adc.microvolts();
    convert(30000.0);
    EXPECT_EQ(adc.gain(circuit), 64);
    EXPECT_EQ(adc.microvolts(), before);
    convert(30000.0, 3);
    EXPECT_EQ(adc.microvolts(), before);
    convert(30000.0);
    EXPECT_NEAR(adc.microvolts(), 30000.0, 39062.5 / 32768 / 2);
    EXPECT_FALSE(adc.is_open());
}

TEST_F(Converter, FullScaleCountsAsOverdrive) {
    verifies<req::TCS_IN_003>();
    convert(19531.25);
    EXPECT_EQ(adc.gain(circuit), 64);
    adc.reset();
    convert(-19531.25);
    EXPECT_EQ(adc.gain(circuit), 64);
    adc.reset();
    convert(19530.0);
    EXPECT_EQ(adc.gain(circuit), 128);
}

TEST_F(Converter, GainRisesWhenTheVoltageFitsWithTenPercentToSpare) {
    verifies<req::TCS_IN_004, req::TCS_IN_016>();
    convert(70000.0, 9);
    ASSERT_EQ(adc.gain(circuit), 32);
    convert(35157.0);  // 90 % of 39062.5 is 35156.25
    EXPECT_EQ(adc.gain(circuit), 32);
    convert(35156.25);
    EXPECT_EQ(adc.gain(circuit), 64);
    EXPECT_NEAR(adc.microvolts(), 35156.25, 78125.0 / 32768 / 2);  // the reading at which the gain changes is valid
    convert(5.0, 3);
    EXPECT_NEAR(adc.microvolts(), 35156.25, 78125.0 / 32768 / 2);
    convert(5.0);
    EXPECT_NEAR(adc.microvolts(), 5.0, 1.2);
    EXPECT_EQ(adc.gain(circuit), 128);  // the gain rises from 64 to 128, which suits 5 uV
}

TEST_F(Converter, GainRisesToTheHighestInOneStep) {
    verifies<req::TCS_IN_004>();
    convert(70000.0, 9);
    convert(17578.0);  // 90 % of 19531.25 is 17578.125
    EXPECT_EQ(adc.gain(circuit), 128);
}

TEST_F(Converter, OpenCircuitIsFoundInTheNinthConversion) {
    verifies<req::TCS_IN_005, req::TCS_IN_006>();
    convert(0.0);
    convert(100000.0, 8);
    EXPECT_FALSE(adc.is_open());
    convert(100000.0);  // the ninth conversion (1 + 4 + 4, with two gain changes), 1485 ms after the break
    EXPECT_TRUE(adc.is_open());
    EXPECT_EQ(adc.microvolts(), 0.0);  // the voltage stays that of the last valid conversion
    convert(25000.0);
    EXPECT_FALSE(adc.is_open());
    EXPECT_NEAR(adc.microvolts(), 25000.0, 1.2);
}

TEST_F(Converter, OverdriveIsEvaluatedOnlyAfterSettling) {
    verifies<req::TCS_IN_006>();
    convert(100000.0, 5);
    convert(0.0, 3);
    EXPECT_FALSE(adc.is_open());
    convert(0.0);
    EXPECT_EQ(adc.microvolts(), 0.0);
    EXPECT_EQ(adc.gain(circuit), 128);
}

TEST_F(Converter, NewFilterSettlesForFourConversions) {
    verifies<req::TCS_IN_008>();
    convert(1000.0);
    adc.unsettle(circuit);
    convert(2000.0, 3);
    EXPECT_NEAR(adc.microvolts(), 1000.0, 0.3);
    convert(2000.0);
    EXPECT_NEAR(adc.microvolts(), 2000.0, 0.3);
}

}  // namespace canproof::test
