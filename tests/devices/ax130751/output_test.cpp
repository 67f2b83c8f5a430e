// SPDX-License-Identifier: Apache-2.0
// Tests scaling and types of the universal outputs of the AX130751, which the tests set up by SDO (manual, 1.2, 1.3).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/output_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// --- scaling (Figure 3) --------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, OutputFollowsProcessValue7300hFrom0To5VoltsAsShipped) {
    verifies<req::AOR_OUT_003, req::AOR_OUT_005, req::AOR_S_VOLTAGE, req::AOR_T03>();
    no_ramps(1);
    command(1, 2500);  // 2.500 V of the range 0…5.000 V
    EXPECT_FLOAT_EQ(volts(1), 2.5F);
    EXPECT_EQ(get16(0x7330, 1), 2500);
    EXPECT_EQ(get16(0x2370, 1), 2500);
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    command(1, 9000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_FLOAT_EQ(volts(2), 0.0F);
    EXPECT_FALSE(is_on(1)) << "no digital output";
}

TEST_F(Ax130751Output, OutputWithAnInverseSlopeFallsAsTheProcessValueRises) {
    verifies<req::AOR_OUT_004>();
    make(10);
    set16(0x7321, 1, 10000);
    set16(0x7323, 1, -10000);
    command(1, 0);
    EXPECT_FLOAT_EQ(volts(1), 10.0F);
    command(1, 1250);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);  // 10 - 20 * 1.25 / 5 = 5
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), -10.0F);
}

TEST_F(Ax130751Output, ProcessAndFieldValueHaveTheirOwnDecimalDigits) {
    verifies<req::AOR_OUT_005>();
    make(10);
    set8(0x6302, 1, 1);      // process value in tenths: its scaling is 0…500.0
    set8(0x6332, 1, 2);      // field value in hundredths of a volt
    set16(0x7321, 1, 0);     // process value 0 becomes 0 V
    set16(0x7323, 1, 1000);  // the largest process value becomes 10.00 V
    command(1, 2500);        // process value 250.0 of 500.0
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_EQ(get16(0x7330, 1), 500);
}

TEST_F(Ax130751Output, ControlResponseClampsOrSwitchesTheOutputOffOutsideScaling1To2) {
    verifies<req::AOR_OUT_006, req::AOR_OUT_031, req::AOR_OUT_015, req::AOR_T06>();
    make(10);
    set16(0x7322, 1, 4000);
    set16(0x7320, 1, 1000);
    set16(0x7321, 1, 1000);
    set16(0x7323, 1, 4000);
    const auto at_ends = [this](int response) {
        set8(0x2342, 1, response);
        std::vector<float> seen;
        for (const int value : {999, 1000, 4000, 4001}) {
            command(1, value);
            seen.push_back(volts(1));
        }
        return seen;
    };
    EXPECT_EQ(at_ends(0), (std::vector<float>{1, 1, 4, 4}));
    EXPECT_EQ(at_ends(1), (std::vector<float>{0, 1, 4, 4}));
    EXPECT_EQ(at_ends(2), (std::vector<float>{1, 1, 4, 0}));
}

// --- types (Table 3) -----------------------------------------------------------------------------------------------

TEST_F(Ax130751Output, CurrentFeedbackIsTheCurrentThroughTheLoad) {
    verifies<req::AOR_OUT_019, req::AOR_S_CURRENT, req::AOR_S_LOAD, req::AOR_K_COMPLIANCE, req::AOR_OUT_044>();
    make(20);
    command(1, 20000);  // commands 20 mA
    EXPECT_FLOAT_EQ(milliamperes(1), 20.0F);
    EXPECT_EQ(get16(0x2370, 1), 20000);
    inputs.load[0] = 1000.0F;  // 20 mA would need 20 V, but the loop has only 14 V: 14 V / 1 kOhm = 14 mA
    set_inputs();
    pass(1);
    EXPECT_FLOAT_EQ(milliamperes(1), 14.0F);
    EXPECT_EQ(get16(0x2370, 1), 14000);
    EXPECT_EQ(get16(0x7330, 1), 20000) << "the target stays";
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
}

TEST_F(Ax130751Output, VoltageOutputIgnoresLoadAndFrequency) {
    verifies<req::AOR_OUT_018, req::AOR_OUT_019, req::AOR_OUT_020>();
    make(10);
    set16(0x2380, 1, 0);
    inputs.load[0] = 10000.0F;  // in a current output 14 V would drive only 1.4 mA; a voltage output is not affected
    set_inputs();
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    EXPECT_EQ(get16(0x2370, 1), 5000);
}

TEST_F(Ax130751Output, PwmOutputRunsAtOutputFrequency2380h) {
    verifies<req::AOR_OUT_020, req::AOR_OUT_021, req::AOR_S_DUTY, req::AOR_S_FREQUENCY, req::AOR_S_LEVEL,
             req::AOR_OUT_047, req::AOR_OUT_048>();
    make(40);
    set16(0x2380, 1, 1200);
    command(1, 375);  // commands 37.5 %
    EXPECT_FLOAT_EQ(duty(1), 37.5F);
    EXPECT_FLOAT_EQ(hertz(1), 1200.0F);
    EXPECT_FLOAT_EQ(level(1), 5.0F);
    set8(0x2240, 1, 1);
    pass(1);
    EXPECT_FLOAT_EQ(level(1), 12.0F);
}

TEST_F(Ax130751Output, PwmWithFrequency0IsOff) {
    verifies<req::AOR_OUT_020, req::AOR_OUT_018, req::AOR_OD_2380>();
    make(40);
    command(1, 375);
    set16(0x2380, 1, 0);
    pass(1);
    EXPECT_FLOAT_EQ(duty(1), 0.0F);
    EXPECT_FLOAT_EQ(hertz(1), 0.0F);
    EXPECT_EQ(get16(0x7330, 1), 375);
    EXPECT_EQ(get16(0x2370, 1), 0);
    set16(0x2380, 1, 1);
    pass(1);
    EXPECT_FLOAT_EQ(duty(1), 37.5F);
}

TEST_F(Ax130751Output, FrequencyOutputHasADutyCycleOfOneHalf) {
    verifies<req::AOR_OUT_035, req::AOR_OUT_021, req::AOR_K_FREQUENCY_DUTY, req::AOR_OUT_046, req::AOR_OUT_048>();
    make(500);
    command(1, 440);
    EXPECT_FLOAT_EQ(hertz(1), 440.0F);
    EXPECT_FLOAT_EQ(duty(1), 50.0F);
    EXPECT_FLOAT_EQ(level(1), 5.0F);
    set8(0x2240, 1, 1);
    pass(1);
    EXPECT_FLOAT_EQ(level(1), 12.0F);
    set8(0x2342, 1, 1);
    command(1, 49);  // below scaling 1: OFF, no pulses
    EXPECT_FLOAT_EQ(hertz(1), 0.0F);
    EXPECT_FLOAT_EQ(duty(1), 0.0F);
}

TEST_F(Ax130751Output, VoltageAndCurrentDoNotDependOnDigitalRange2240h) {
    verifies<req::AOR_OUT_036>();
    make(10);
    set8(0x2240, 1, 1);
    command(1, 3000);
    EXPECT_FLOAT_EQ(volts(1), 3.0F);
    EXPECT_FLOAT_EQ(level(1), 0.0F);
    make(20);
    command(1, 3000);
    EXPECT_FLOAT_EQ(milliamperes(1), 3.0F);
    EXPECT_FLOAT_EQ(level(1), 0.0F);
}

TEST_F(Ax130751Output, OutputOfType0HasNoVoltageAndNoFeedback) {
    verifies<req::AOR_OUT_025, req::AOR_OUT_049>();
    make(10);
    command(1, 3000);
    make(0);
    command(1, 3000);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_EQ(get16(0x7330, 1), 0);
    EXPECT_EQ(get16(0x2370, 1), 0);
}

TEST_F(Ax130751Output, OutputOfType0IgnoresOverrideAndFaultValue) {
    verifies<req::AOR_OUT_025, req::AOR_OUT_049>();
    make(10);
    set16(0x2300, 1, 3000);
    set16(0x7341, 1, 3000);
    set16(0x1400, 5, 20);
    connect(0x2360, 2);
    start();
    const auto drives = [this] {
        pass(1);
        return volts(1) != 0.0F || milliamperes(1) != 0.0F || duty(1) != 0.0F || is_on(1) || get16(0x7330, 1) != 0 ||
               get16(0x2370, 1) != 0;
    };
    for (const int type : {10, 0}) {
        SCOPED_TRACE(type);
        set16(0x6310, 1, type);
        extra(2, 100);
        EXPECT_EQ(drives(), type != 0) << "override";
        extra(2, 0);
        send("27F#0000000000");
        EXPECT_FALSE(drives());
        pass(20);
        EXPECT_EQ(drives(), type != 0) << "fault";
    }
}

TEST_F(Ax130751Output, OutputOfType10StaysWithin10Volts) {
    verifies<req::AOR_OUT_016>();
    make(10);
    set16(0x7323, 1, 10000);
    set8(0x6332, 1, 2);  // 6332h = 2: the scaling 10000 (10.000 V) now means 100.00 V
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 10.0F);
    EXPECT_EQ(get16(0x7330, 1), 1000);
}

TEST_F(Ax130751Output, FieldValuesOutsideTheRangeOfTheTypeAreRefused) {
    verifies<req::AOR_OUT_024, req::AOR_OUT_039, req::AOR_OUT_040, req::AOR_OUT_051, req::AOR_OUT_052>();
    for (const int output : {1, 2}) {
        set16(0x6310, 3 - output, 40);  // the other output has type 40 (PWM), whose limit is 1000 (100.0 %)
        for (const std::uint16_t index : std::array<std::uint16_t, 4>{0x7321, 0x7323, 0x2300, 0x7341}) {
            SCOPED_TRACE(fmt::format("output {}, {:04X}h", output, index));
            set16(0x6310, output, 10);
            EXPECT_EQ(write(index, output, 10000, 2), "");
            EXPECT_EQ(write(index, output, 10001, 2), "06090031");
            EXPECT_EQ(write(index, output, -10000, 2), "");
            EXPECT_EQ(write(index, output, -10001, 2), "06090032");
            set8(0x6332, output, 2);  // two decimal digits: 1000 is 10.00 V
            EXPECT_EQ(write(index, output, 1000, 2), "");
            EXPECT_EQ(write(index, output, 1001, 2), "06090031");
            set16(0x6310, output, 500);
            EXPECT_EQ(write(index, output, 49, 2), "06090032");
            EXPECT_EQ(write(index, output, 50, 2), "");
            EXPECT_EQ(write(index, output, 0, 2), "") << "OFF";
            EXPECT_EQ(write(index, output, 30001, 2), "06090031");
            set16(0x6310, output, 20);
            EXPECT_EQ(write(index, output, 24000, 2), "");
            EXPECT_EQ(write(index, output, 24001, 2), "06090031");
            EXPECT_EQ(write(index, output, -1, 2), "06090032");
            set16(0x6310, output, 40);
            EXPECT_EQ(write(index, output, 1000, 2), "") << "100.0 %";
            EXPECT_EQ(write(index, output, 1001, 2), "06090031");
            EXPECT_EQ(write(index, output, -1, 2), "06090032");
            set16(0x6310, output, 1020);
            EXPECT_EQ(write(index, output, 1, 2), "");
            EXPECT_EQ(write(index, output, 2, 2), "06090031");
            EXPECT_EQ(write(index, output, -1, 2), "06090032");
            set16(0x6310, output, 0);
            EXPECT_EQ(write(index, output, 32767, 2), "");
            EXPECT_EQ(write(index, output, -32768, 2), "");
        }
    }
}

TEST_F(Ax130751Output, AutomaticUpdateWritesTheDefaultsOfTheNewOutputType) {
    verifies<req::AOR_OUT_022, req::AOR_OUT_037, req::AOR_T_TYPE_DEFAULTS>();
    struct Row {
        int type, digits, scaling_1, scaling_2;
    };
    for (const auto& row : {Row{20, 3, 0, 20000}, Row{40, 1, 0, 1000}, Row{500, 0, 50, 30000}, Row{1020, 0, 0, 1},
                            Row{10, 3, 0, 5000}, Row{1000, 0, 0, 1}}) {
        set16(0x6310, 2, row.type);
        EXPECT_EQ(get8(0x6302, 2), row.digits) << row.type;
        EXPECT_EQ(get8(0x6332, 2), row.digits) << row.type;
        EXPECT_EQ(get16(0x7320, 2), row.scaling_1) << row.type;
        EXPECT_EQ(get16(0x7322, 2), row.scaling_2) << row.type;
        EXPECT_EQ(get16(0x7321, 2), row.scaling_1) << row.type;
        EXPECT_EQ(get16(0x7323, 2), row.scaling_2) << row.type;
        EXPECT_EQ(get16(0x2300, 2), 0) << row.type;
        EXPECT_EQ(get16(0x7341, 2), 0) << row.type;
    }
    EXPECT_EQ(get16(0x7322, 1), 5000) << "the other output is not concerned";
}

TEST_F(Ax130751Output, NewOutputTypeWritesNoDefaultsWithoutAutomaticUpdates) {
    verifies<req::AOR_OUT_038>();
    set8(0x5550, 0, 0);
    set16(0x7341, 1, 1000);
    set16(0x6310, 1, 40);
    EXPECT_EQ(get8(0x6302, 1), 3);
    EXPECT_EQ(get16(0x7323, 1), 5000);
    EXPECT_EQ(get16(0x7341, 1), 1000);
}

TEST_F(Ax130751Output, SelectingTheSameOutputTypeOrType0WritesNoDefaults) {
    verifies<req::AOR_OUT_038>();
    set16(0x7323, 1, 4000);
    set16(0x6310, 1, 10);
    EXPECT_EQ(get16(0x7323, 1), 4000);
    set16(0x6310, 1, 0);
    EXPECT_EQ(get16(0x7323, 1), 4000);
}

TEST_F(Ax130751Output, OutputRampsFromOffAfterAChangeOfItsType) {
    verifies<req::AOR_OUT_023, req::AOR_OUT_014>();
    set8(0x5550, 0, 0);
    make(10);
    command(1, 5000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    set16(0x2330, 1, 1000);
    set16(0x6310, 1, 40);
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FLOAT_EQ(duty(1), 0.0F);
    pass(500);
    EXPECT_FLOAT_EQ(duty(1), 2.5F) << "5 % in a second, from OFF";
}

// Output 1 follows its own target (source 6) or its own feedback (source 7). After a type change, both values of the
// old type are cleared before the output reads them.
TEST_F(Ax130751Output, OutputThatFollowsItselfStartsFromOffAfterATypeChange) {
    verifies<req::AOR_OUT_023, req::AOR_OUT_050>();
    set8(0x5550, 0, 0);
    for (const int source : {6, 7}) {
        SCOPED_TRACE(source);
        set8(0x2340, 1, canopen);
        make(10);
        command(1, 5000);
        EXPECT_FLOAT_EQ(volts(1), 5.0F);
        set8(0x2340, 1, source);
        pass(1);
        EXPECT_FLOAT_EQ(volts(1), 5.0F) << "it keeps its own value";
        set16(0x6310, 1, 20);
        pass(1);
        EXPECT_EQ(get16(0x7330, 1), 0) << "5.000 V is no current";
        EXPECT_EQ(get16(0x2370, 1), 0);
        EXPECT_FLOAT_EQ(milliamperes(1), 0.0F);
    }
}

}  // namespace canproof::test
