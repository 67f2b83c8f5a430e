// SPDX-License-Identifier: Apache-2.0
// Tests values that are calculated from terminal voltages: conversion, compensation, scaling, average, cold junction
// (AX188001 manual, 1.1 to 1.3, 3.3, 3.4).
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001Values = TcsTest;

int round_to_int(double value) {
    return static_cast<int>(std::lround(value));
}

}  // namespace

TEST_F(Ax188001Values, BothChannelsShowTheTemperatureOfTheirTerminalsAtPowerOn) {
    verifies<req::TCS_IN_001, req::TCS_VAL_002, req::TCS_OD_6100, req::TCS_OD_7130, req::TCS_S_COLD_JUNCTION>();
    EXPECT_NEAR(field_value(1).real(), 25.0F, 0.02F);
    EXPECT_NEAR(field_value(2).real(), 25.0F, 0.02F);
    EXPECT_EQ(process_value(1), 25 * 16 + 4368);
    EXPECT_EQ(process_value(2), 25 * 16 + 4368);
}

TEST_F(Ax188001Values, EachThermocoupleTypeErrsByAtMostOneDegreeOverItsRange) {
    verifies<req::TCS_IN_012, req::TCS_CONV_001, req::TCS_OD_6110, req::TCS_E_SENSOR_TYPE, req::TCS_IN_002>();
    for (const auto& type : its90_types()) {
        ASSERT_EQ(write(0x6110, 1, 2, static_cast<std::uint32_t>(type.number)), 0U);
        // Type B rises by 0.34 uV/K at 50 degC: half a step of 0.596 uV is 0.9 degC.
        const double from = type.letter == 'B' ? 50.0 : static_cast<double>(type.lowest());
        for (double celsius = from; celsius <= static_cast<double>(type.highest()); celsius += 61.7) {
            heat(1, celsius, type.letter);
            settle();
            ASSERT_NEAR(static_cast<double>(field_value(1).real()), celsius, 1.0) << type.letter;
            const int expected = std::min(32767, round_to_int(celsius * 16.0 + 4368.0));
            ASSERT_NEAR(process_value(1), expected, 16) << type.letter << " at " << celsius;
        }
    }
}

TEST_F(Ax188001Values, ThermocoupleTypeEVoltageBeyondTheConverterIsReadAsOpenCircuit) {
    verifies<req::TCS_IN_012, req::TCS_IN_018, req::TCS_IN_006>();
    EXPECT_EQ(write(0x6110, 1, 2, 9), 0U);
    inputs.cold_junction = -40.0F;  // with type E, the cold junction at -40 degC has -2.255 mV
    heat(1, 990.0, 'E');            // at 990 degC type E has 75.621 mV, so the terminals have 75.621 + 2.255 = 77.876
                                    // mV
    settle();
    EXPECT_NEAR(field_value(1).real(), 990.0F, 1.0F);
    heat(1, 1000.0, 'E');  // at 1000 degC: 76.373 + 2.255 = 78.628 mV at the terminals, more than the converter's
                           // 78.125 mV
    settle();
    EXPECT_EQ(process_value(1), -512);
}

TEST_F(Ax188001Values, ColdJunctionIsCompensatedInTheVoltageDomain) {
    verifies<req::TCS_CJ_003, req::TCS_IN_009, req::TCS_OD_2010>();
    // Type K has 41.276 mV at 1000 degC and 1.000 mV at 25 degC. If the device added temperatures instead of voltages,
    // it would give 25 degC + T(40.276 mV) = 999.3 degC.
    write(0x6110, 1, 2, 2);
    microvolts(1, 41276.0 - 1000.0);
    settle();
    EXPECT_NEAR(field_value(1).real(), 1000.0F, 0.1F);
    EXPECT_NEAR(read(0x2010, 1).value, 41276, 2);
    inputs.cold_junction = 85.0F;  // type K has 3.474 mV at 85 degC, so the terminal voltage now means about 1060 degC
    set_inputs();
    settle();
    EXPECT_NEAR(read(0x2010, 1).value, 40276 + 3474, 2);
    EXPECT_NEAR(field_value(1).real(), 1062.5F, 2.0F);
}

/// Processor temperature and supply voltage stay at 25, the first value of the cold junction, so that the test notices
/// when the device uses a wrong input.
TEST_F(Ax188001Values, ChangeOfTheColdJunctionTemperatureAloneIsCompensated) {
    verifies<req::TCS_CJ_003, req::TCS_IN_009>();
    inputs.cpu_temperature = 25.0F;
    inputs.supply = 25.0F;
    for (const float cold_junction : {25.0F, 60.0F, -10.0F}) {
        inputs.cold_junction = cold_junction;
        heat(1, 100.0);
        settle();
        EXPECT_EQ(process_value(1), 100 * 16 + 4368) << cold_junction;
    }
}

TEST_F(Ax188001Values, OnlyTheTerminalVoltageIsConvertedWithoutCompensation) {
    verifies<req::TCS_IN_010, req::TCS_OD_2000, req::TCS_IN_011>();
    EXPECT_EQ(read(0x2000, 1).value, 1U);
    EXPECT_EQ(write(0x2000, 1, 1, 0), 0U);
    microvolts(1, 27393.0);  // J at 500 degC
    microvolts(2, 27393.0);
    settle();
    EXPECT_NEAR(field_value(1).real(), 500.0F, 0.05F);
    EXPECT_NEAR(read(0x2010, 1).value, 27393, 1);
    EXPECT_GT(field_value(2).real(), 520.0F);
    EXPECT_EQ(write(0x2000, 1, 1, 2), too_high);
}

TEST_F(Ax188001Values, ThermocoupleTypeBIsConvertedWithAColdJunctionBelow0Degrees) {
    verifies<req::TCS_CJ_003, req::TCS_CJ_005>();
    inputs.cold_junction = -40.0F;
    write(0x6110, 1, 2, 10);
    // Type B has 4.834 mV at 1000 degC and, by the polynomial, 19.4 uV at -40 degC.
    microvolts(1, 4834.0 - 19.4);
    settle();
    EXPECT_NEAR(field_value(1).real(), 1000.0F, 0.2F);
}

TEST_F(Ax188001Values, MeasuredVoltageIsASignedIntegerInMicrovolts) {
    verifies<req::TCS_IN_009, req::TCS_OD_2010>();
    write(0x2000, 2, 1, 0);
    microvolts(2, -1235.2);
    read_once();
    EXPECT_EQ(static_cast<std::int32_t>(read(0x2010, 2).value), -1235);  // 2072 steps of 0.59605 uV
    EXPECT_EQ(read(0x2010, 2).size, 4);
}

TEST_F(Ax188001Values, ProcessValueFactorAndOffsetCanGiveDegreesFahrenheit) {
    verifies<req::TCS_VAL_003, req::TCS_VAL_008, req::TCS_OD_6126, req::TCS_OD_6127>();
    heat(2, 100.0);
    read_once();
    EXPECT_EQ(write_real(0x6126, 2, 18.0F), 0U);
    EXPECT_EQ(write_real(0x6127, 2, 320.0F), 0U);
    EXPECT_EQ(process_value(2), 2120);  // the new scaling applies at once, to the last reading
    EXPECT_EQ(process_value(1), 4768);
}

TEST_F(Ax188001Values, ScalingOutsideItsLimitsIsRefused) {
    verifies<req::CO_SDO_040, req::TCS_VAL_009, req::TCS_OD_6126, req::TCS_OD_6127, req::TCS_OD_2126, req::TCS_OD_2127,
             req::TCS_OD_3126, req::TCS_OD_3127>();
    struct Place {
        int index;
        int sub;
    };
    for (const Place factor : {Place{0x6126, 1}, Place{0x6126, 2}, Place{0x2126, 0}, Place{0x3126, 0}}) {
        EXPECT_EQ(read(factor.index, factor.sub).real(), 16.0F);
        EXPECT_EQ(write_real(factor.index, factor.sub, 1000.5F), too_high);
        EXPECT_EQ(write_real(factor.index, factor.sub, -1000.5F), too_low);
        EXPECT_EQ(write(factor.index, factor.sub, 4, 0x7FC00000), out_of_range);
        EXPECT_EQ(write(factor.index, factor.sub, 4, 0x7F800000), out_of_range);
        EXPECT_EQ(write_real(factor.index, factor.sub, -1000.0F), 0U);
        EXPECT_EQ(write_real(factor.index, factor.sub, 1000.0F), 0U);
    }
    for (const Place offset : {Place{0x6127, 1}, Place{0x6127, 2}, Place{0x2127, 0}, Place{0x3127, 0}}) {
        EXPECT_EQ(read(offset.index, offset.sub).real(), 4368.0F);
        EXPECT_EQ(write_real(offset.index, offset.sub, 10000.5F), too_high);
        EXPECT_EQ(write_real(offset.index, offset.sub, -10000.5F), too_low);
        EXPECT_EQ(write_real(offset.index, offset.sub, 10000.0F), 0U);
        EXPECT_EQ(write_real(offset.index, offset.sub, -10000.0F), 0U);
    }
}

TEST_F(Ax188001Values, ProcessValuesStayWithinSixteenBits) {
    verifies<req::TCS_VAL_004, req::TCS_OD_2130, req::TCS_OD_3130>();
    for (const int index : {0x6126, 0x2126, 0x3126}) {
        write_real(index, index == 0x6126 ? 1 : 0, 1000.0F);
        write_real(index + 1, index == 0x6126 ? 1 : 0, 10000.0F);
    }
    EXPECT_EQ(process_value(1), 32767);  // 25 * 1000 + 10000 = 35000
    EXPECT_EQ(read(0x2130).word(), 32767);
    EXPECT_EQ(read(0x3130).word(), 32767);
    for (const int index : {0x6126, 0x2126, 0x3126}) {
        write_real(index, index == 0x6126 ? 1 : 0, -1000.0F);
        write_real(index + 1, index == 0x6126 ? 1 : 0, -10000.0F);
    }
    EXPECT_EQ(process_value(1), -32768);
    EXPECT_EQ(read(0x2130).word(), -32768);
    EXPECT_EQ(read(0x3130).word(), -32768);
}

TEST_F(Ax188001Values, DisabledChannelShowsNanAndProcessValueMinus1) {
    verifies<req::TCS_VAL_005, req::TCS_OD_6112, req::TCS_K_FV_DISABLED, req::TCS_K_PV_DISABLED, req::TCS_IN_013>();
    EXPECT_EQ(read(0x6112, 1).value, 1U);
    EXPECT_EQ(write(0x6112, 1, 1, 0), 0U);
    EXPECT_EQ(field_value(1).value, not_a_number);
    EXPECT_EQ(read(0x7130, 1).value, 0xFFFFU);
    heat(1, 100.0);
    read_once();
    EXPECT_EQ(field_value(1).value, not_a_number);
    EXPECT_NEAR(read(0x2010, 1).value, 5269, 1);  // J at 100 degC
    EXPECT_EQ(write(0x6112, 1, 1, 1), 0U);
    EXPECT_EQ(process_value(1), 5968);
    EXPECT_EQ(write(0x6112, 1, 1, 2), too_high);
}

TEST_F(Ax188001Values, OpenCircuitIsShownBeforeItsFaultDelayEndsAndKeepsTheLastVoltage) {
    verifies<req::TCS_VAL_006, req::TCS_K_PV_OPEN, req::TCS_IN_006, req::TCS_IN_019, req::TCS_S_OPEN>();
    const auto before = read(0x2010, 1).value;
    cut(1);
    pass(8 * 165);
    EXPECT_EQ(process_value(1), 4768);  // the break is not known yet, because two gain changes take four readings each
    pass(165);                          // 1485 ms after the break
    EXPECT_EQ(read(0x7130, 1).value, 0xFE00U);
    EXPECT_EQ(field_value(1).value, not_a_number);
    EXPECT_EQ(read(0x2010, 1).value, before);
    inputs.cold_junction = 60.0F;
    set_inputs();
    read_once();
    // a new compensation does not change the voltage while the circuit is open
    EXPECT_EQ(read(0x2010, 1).value, before);
    inputs.cold_junction = 25.0F;
    set_inputs();
    read_once();
    EXPECT_EQ(status(1), 0);  // the delay of 4030h (TC Error React Delay) has not passed, so the status shows no fault
    EXPECT_EQ(process_value(2), 4768);
    cut(1, false);
    read_once();
    EXPECT_EQ(process_value(1), 4768);
}

/// Without a voltage since power-on or a reset of the node, 2010h (TC Input Microvolts) is 0.
TEST_F(Ax188001Values, VoltageOfACircuitThatIsOpenAtPowerOnIsZero) {
    verifies<req::TCS_IN_019>();
    const auto before = read(0x2010, 1).value;
    EXPECT_NE(before, 0U);
    cut(1);
    settle();
    EXPECT_EQ(read(0x2010, 1).value, before);
    send("000#827F");
    EXPECT_EQ(read(0x2010, 1).value, before);
    for (const bool by_power : {false, true}) {
        if (by_power) {
            power_on();
        } else {
            send("000#817F");
        }
        EXPECT_EQ(read(0x7130, 1).value, 0xFE00U);
        EXPECT_EQ(read(0x2010, 1).value, 0U);
        settle();
        EXPECT_EQ(read(0x2010, 1).value, 0U);
        EXPECT_EQ(read(0x2010, 2).value, before);
    }
}

TEST_F(Ax188001Values, OnlyThermocoupleTypesOfTable1AreAcceptedAndTheyApplyAtOnce) {
    verifies<req::TCS_IN_014, req::TCS_IN_020, req::TCS_T1, req::TCS_OD_6110, req::TCS_IN_011>();
    EXPECT_EQ(read(0x6110, 1).value, 1U);
    for (const std::uint32_t type : {0U, 3U, 8U, 11U, 12U, 257U, 65535U}) {
        EXPECT_EQ(write(0x6110, 1, 2, type), out_of_range) << type;
    }
    microvolts(1, 4096.0);  // 4.096 mV + 1.000 mV (type K at the cold junction) is about 124 degC
    read_once();
    EXPECT_EQ(write(0x6110, 1, 2, 2), 0U);
    EXPECT_NEAR(field_value(1).real(), 124.3F, 0.5F);
    EXPECT_NEAR(field_value(2).real(), 25.0F, 0.02F);
    for (const std::uint32_t type : {1U, 2U, 4U, 5U, 6U, 7U, 9U, 10U}) {
        EXPECT_EQ(write(0x6110, 2, 2, type), 0U) << type;
    }
}

TEST_F(Ax188001Values, ValueThatScalesToAReservedValueIsMovedByOne) {
    verifies<req::TCS_VAL_007, req::TCS_VAL_001, req::TCS_CJ_004>();
    heat(1, 100.0);
    read_once();
    write_real(0x6126, 1, 0.0F);
    write_real(0x6127, 1, -1.0F);
    EXPECT_EQ(process_value(1), 0);
    write_real(0x6127, 1, -512.0F);
    EXPECT_EQ(process_value(1), -511);
    write_real(0x6127, 1, -2.5F);
    EXPECT_EQ(process_value(1), -3);
    write_real(0x2126, 0, 0.0F);
    write_real(0x2127, 0, -1.0F);
    EXPECT_EQ(read(0x2130).word(), 0);
    write_real(0x3126, 0, 0.0F);
    write_real(0x3127, 0, -1.0F);
    EXPECT_EQ(read(0x3130).word(), -1);
}

TEST_F(Ax188001Values, AverageUsesTheValidChannels) {
    verifies<req::TCS_AVG_001, req::TCS_AVG_005, req::TCS_AVG_002, req::TCS_OD_2100, req::TCS_OD_2130>();
    heat(1, 100.0);
    heat(2, 200.0);
    read_once();
    EXPECT_NEAR(read(0x2100).real(), 150.0F, 0.02F);
    EXPECT_EQ(read(0x2130).word(), 150 * 16 + 4368);
    write_real(0x2126, 0, 10.0F);
    write_real(0x2127, 0, 0.0F);
    EXPECT_EQ(read(0x2130).word(), 1500);
    write(0x6112, 1, 1, 0);
    EXPECT_EQ(read(0x2130).word(), 2000);
    write(0x6112, 1, 1, 1);
    cut(2);
    settle();
    EXPECT_EQ(read(0x2130).word(), 1000);
}

TEST_F(Ax188001Values, AverageCanBeSwitchedOff) {
    verifies<req::TCS_AVG_003, req::TCS_OD_2112, req::TCS_T2>();
    EXPECT_EQ(read(0x2112).value, 1U);
    EXPECT_EQ(read(0x2112).size, 1);
    EXPECT_EQ(write(0x2112, 0, 1, 0), 0U);
    EXPECT_EQ(read(0x2100).value, not_a_number);
    EXPECT_EQ(read(0x2130).value, 0xFFFFU);
    EXPECT_EQ(write(0x2112, 0, 1, 2), too_high);
    cut(1);
    cut(2);
    settle();
    EXPECT_EQ(read(0x2130).value, 0xFFFFU);
    cut(1, false);
    read_once();
    EXPECT_EQ(write(0x2112, 0, 1, 1), 0U);
    EXPECT_EQ(read(0x2130).word(), 4768);
}

TEST_F(Ax188001Values, AverageWithoutAValidChannelShowsTheReason) {
    verifies<req::TCS_AVG_004, req::TCS_AVG_006, req::TCS_AVG_007>();
    write(0x6112, 1, 1, 0);
    write(0x6112, 2, 1, 0);
    EXPECT_EQ(read(0x2100).value, not_a_number);
    EXPECT_EQ(read(0x2130).value, 0xFFFFU);
    cut(2);
    settle();
    EXPECT_EQ(read(0x2130).value, 0xFFFFU);  // channel 2 is disabled, so its broken wire has no effect
    write(0x6112, 2, 1, 1);
    EXPECT_EQ(read(0x2100).value, not_a_number);
    EXPECT_EQ(read(0x2130).value, 0xFE00U);
    cut(1);
    cut(2, false);
    settle();
    write(0x6112, 1, 1, 1);
    write(0x6112, 2, 1, 0);
    EXPECT_EQ(read(0x2130).value, 0xFE00U);  // the wire of channel 1, now the only enabled channel, is broken
}

TEST_F(Ax188001Values, ColdJunctionHasItsOwnFieldAndProcessValue) {
    verifies<req::TCS_CJ_001, req::TCS_CJ_002, req::TCS_CJ_006, req::TCS_OD_3100, req::TCS_OD_3130,
             req::TCS_S_COLD_JUNCTION, req::TCS_K_CJ_LOWEST, req::TCS_K_CJ_HIGHEST>();
    inputs.cold_junction = -40.0F;
    set_inputs();
    EXPECT_EQ(read(0x3100).real(), 25.0F);
    read_once();
    EXPECT_EQ(read(0x3100).real(), -40.0F);
    EXPECT_EQ(read(0x3130).word(), -40 * 16 + 4368);
    EXPECT_EQ(read(0x3130).size, 2);
    inputs.cold_junction = 110.0F;
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x3130).word(), 110 * 16 + 4368);
    inputs.cold_junction = 110.5F;
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x3100).real(), 110.0F);
    inputs.cold_junction = -40.5F;
    set_inputs();
    read_once();
    EXPECT_EQ(read(0x3100).real(), -40.0F);
    inputs.cold_junction = 110.0F;
    set_inputs();
    read_once();
    write_real(0x3126, 0, 10.0F);
    write_real(0x3127, 0, -5.0F);
    EXPECT_EQ(read(0x3130).word(), 1095);
}

TEST_F(Ax188001Values, SettingsOfOneChannelDoNotAffectTheOther) {
    verifies<req::TCS_IN_011>();
    write(0x6110, 1, 2, 2);
    write(0x2000, 1, 1, 0);
    write_real(0x6126, 1, 1.0F);
    write_real(0x6127, 1, 0.0F);
    write(0x4010, 1, 2, 200);
    heat(1, 300.0, 'K');
    settle();
    EXPECT_EQ(process_value(2), 4768);
    pass(10000);
    EXPECT_EQ(status(2), 0);
    write(0x6112, 2, 1, 0);
    EXPECT_NE(field_value(1).value, not_a_number);
}

}  // namespace canproof::test
