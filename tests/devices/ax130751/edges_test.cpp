// SPDX-License-Identifier: Apache-2.0
// Checks the constants of the AX130751 (manual, 1.2 to 1.8, 4) just below and just above each, within 1 % of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

float next_above(float value) {
    return std::nextafter(value, infinite);
}
float next_below(float value) {
    return std::nextafter(value, -infinite);
}

class Ax130751Edges : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        no_ramps(1);
        no_ramps(2);
    }
    /// Returns the code of the emergency message that a supply voltage causes in the next cycle; "" when the device
    /// sends none.
    std::string supply(float volts_supplied) {
        inputs.supply = volts_supplied;
        set_inputs();
        return emergency();
    }
    std::string temperature(float degrees) {
        inputs.cpu_temperature = degrees;
        set_inputs();
        return emergency();
    }
    std::string emergency() {
        std::string codes;
        for (const std::string& frame : pass(1)) {
            const std::size_t at_id = frame.find("0FF#");
            codes += at_id == std::string::npos ? "" : reversed(frame.substr(at_id + 4, 4));
        }
        return codes;
    }
    void make(int output, int type) {
        set16(0x6310, output, type);
        set8(0x2342, output, 0);
        pass(1);
    }
    /// Overrides output 1 with 2300h (AO Override Field Value), whatever its control.
    void override_with(int field_value) {
        set16(0x2300, 1, field_value);
        pass(1);
    }
    void override_always() {
        extra_as_percent(1);
        set8(0x2360, 1, canopen);
        set8(0x2361, 1, 4);
        set8(0x2362, 1, 1);  // override response 1: the override works while its input is OFF
    }
    /// Sets up math block 1 with one operator. Its inputs are 2500h:1 and 2500h:2 (EC Extra Received Process Value)
    /// divided by 10000.
    void make_math(int operation) {
        for (int input = 1; input <= 2; ++input) {
            set8(0x2502, input, 0);
            set16(0x2522, input, 10000);
            set8(0x4101, input, 3 + input);
            set8(0x4100, input, canopen);
            set8(0x4103, input, 0);
            set16(0x4122, input, 10000);
        }
        set8(0x4150, 1, operation);
        set8(0x4000, 1, 1);
    }
    int math_of(int first, int second) {
        set16(0x2500, 1, first);
        set16(0x2500, 2, second);
        pass(1);
        return get16(0x4030, 1);
    }
};

}  // namespace

// --- supply and temperature (1.8, chapter 4) -----------------------------------------------------------------------

TEST_F(Ax130751Edges, UnderVoltageBeginsBelow8VoltsAndEndsAt13Volts) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_007, req::AOR_DIAG_012, req::AOR_OD_5022, req::AOR_OD_5024,
             req::AOR_DIAG_015>();
    EXPECT_EQ(supply(8.0F), "");
    EXPECT_EQ(supply(next_below(8.0F)), "3100");
    EXPECT_EQ(supply(8.0F), "") << "it goes on above its threshold";
    EXPECT_EQ(supply(next_below(13.0F)), "");
    EXPECT_EQ(supply(13.0F), "0000");
}

TEST_F(Ax130751Edges, OverVoltageBeginsAbove35VoltsAndEndsAt30Volts) {
    verifies<req::AOR_DIAG_003, req::AOR_DIAG_007, req::AOR_DIAG_012, req::AOR_OD_5023, req::AOR_OD_5024,
             req::AOR_DIAG_016>();
    EXPECT_EQ(supply(35.0F), "");
    EXPECT_EQ(supply(next_above(35.0F)), "3100");
    EXPECT_EQ(supply(35.0F), "") << "it goes on below its threshold";
    EXPECT_EQ(supply(next_above(30.0F)), "");
    EXPECT_EQ(supply(30.0F), "0000");
}

TEST_F(Ax130751Edges, OverTemperatureBeginsAbove85DegreesAndEndsAt60Degrees) {
    verifies<req::AOR_DIAG_004, req::AOR_DIAG_012, req::AOR_OD_5032, req::AOR_OD_5033, req::AOR_DIAG_017,
             req::AOR_DIAG_019>();
    EXPECT_EQ(temperature(85.0F), "");
    EXPECT_EQ(temperature(next_above(85.0F)), "4200");
    EXPECT_EQ(temperature(85.0F), "") << "it goes on below its threshold";
    EXPECT_EQ(temperature(next_above(60.0F)), "");
    EXPECT_EQ(temperature(60.0F), "0000");
}

TEST_F(Ax130751Edges, ConfiguredThresholdsAreExactToTheNextFloat) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_003, req::AOR_DIAG_004>();
    set8(0x5022, 0, 20);
    set8(0x5023, 0, 28);
    set8(0x5024, 0, 3);
    set8(0x5032, 0, 100);
    set8(0x5033, 0, 1);
    EXPECT_EQ(supply(20.0F), "");
    EXPECT_EQ(supply(next_below(20.0F)), "3100");
    EXPECT_EQ(supply(next_below(23.0F)), "");
    EXPECT_EQ(supply(23.0F), "0000");
    EXPECT_EQ(supply(28.0F), "");
    EXPECT_EQ(supply(next_above(28.0F)), "3100");
    EXPECT_EQ(supply(next_above(25.0F)), "");
    EXPECT_EQ(supply(25.0F), "0000");
    EXPECT_EQ(temperature(100.0F), "");
    EXPECT_EQ(temperature(next_above(100.0F)), "4200");
    EXPECT_EQ(temperature(next_above(99.0F)), "");
    EXPECT_EQ(temperature(99.0F), "0000");
}

TEST_F(Ax130751Edges, OutputsRunFrom7To39VoltsWithoutHysteresisWhenFaultDetectionIsOff) {
    verifies<req::AOR_DIAG_008, req::AOR_K_SUPPLY_SHUTDOWN_LOW, req::AOR_K_SUPPLY_SHUTDOWN_HIGH>();
    set8(0x5021, 0, 0);
    command(1, 2000);
    const auto runs = [this](float volts_supplied) {
        EXPECT_EQ(supply(volts_supplied), "");
        EXPECT_EQ(device->outputs().relay_no, volts(1) > 0.0F) << "the coil of the relay that is OFF";
        return volts(1) == 2.0F;
    };
    EXPECT_TRUE(runs(7.0F));
    EXPECT_FALSE(runs(next_below(7.0F)));
    EXPECT_TRUE(runs(7.0F)) << "without a hysteresis";
    EXPECT_TRUE(runs(39.0F));
    EXPECT_FALSE(runs(next_above(39.0F)));
    EXPECT_TRUE(runs(39.0F));
}

TEST_F(Ax130751Edges, SupplyAndTemperatureAsControlSourcesAreRoundedToTenths) {
    verifies<req::AOR_SRC_008>();
    // Lookup table 1 has Y = X, in hundredths, from -300.00 to 300.00.
    set8(0x3013, 0, 2);
    set8(0x3014, 0, 2);
    set16(0x3017, 1, -30000);
    set32(0x3016, 1, -30000);
    for (int point = 11; point >= 2; --point) {
        set16(0x3017, point, 30000);
        set32(0x3016, point, 30000);
    }
    const auto hundredths = [this](int source) {
        set8(0x3010, 0, source);
        pass(2);
        return get16(0x3018, 0);
    };
    supply(24.2499F);
    temperature(-12.2501F);
    EXPECT_EQ(hundredths(supply_source), 2420);
    EXPECT_EQ(hundredths(9), -1230);
    supply(24.2501F);
    temperature(-12.2499F);
    EXPECT_EQ(hundredths(supply_source), 2430);
    EXPECT_EQ(hundredths(9), -1220);
}

// --- outputs (1.2, 1.3, chapter 4) ---------------------------------------------------------------------------------

TEST_F(Ax130751Edges, CurrentIsLimitedByALoopVoltageOf14Volts) {
    verifies<req::AOR_OUT_019, req::AOR_K_COMPLIANCE, req::AOR_K_RESISTOR_SCALE>();
    for (int output = 1; output <= 2; ++output) {
        make(output, 20);
        command(output, 20000);
        const auto microamperes = [this, output](float ohm) {
            inputs.load.at(at(output)) = ohm;
            set_inputs();
            pass(1);
            return get16(0x2370, output);
        };
        EXPECT_EQ(microamperes(699.9F), 20000);
        EXPECT_EQ(microamperes(700.0F), 20000);  // 14 V / 700 Ohm = 20 mA
        EXPECT_EQ(microamperes(700.5F), 19986);  // 14 V / 700.5 Ohm = 19.9857 mA
        EXPECT_EQ(microamperes(14000.0F), 1000);
        EXPECT_EQ(microamperes(0.0F), 20000);
    }
}

TEST_F(Ax130751Edges, OutputOfEachTypeIsDrivenWithinItsRange) {
    verifies<req::AOR_OUT_016, req::AOR_OUT_034, req::AOR_T03, req::AOR_E_OUTPUT_TYPE>();
    struct Case {
        int type;
        int integer;    ///< 2300h (AO Override Field Value), written while it is within the range of the type
        int digits;     ///< 6332h (AO Decimal Digits FV), written after `integer`
        double driven;  ///< V, mA, %, Hz
    };
    override_always();
    const std::map<int, int> own_digits{{10, 3}, {20, 3}, {40, 1}, {500, 0}};
    for (const Case& one : std::vector<Case>{
             {10, 999, 2, 9.99},    {10, 1000, 2, 10.0},   {10, 1001, 2, 10.0},      {10, -999, 2, -9.99},
             {10, -1000, 2, -10.0}, {10, -1001, 2, -10.0}, {20, 2399, 2, 23.99},     {20, 2400, 2, 24.0},
             {20, 2401, 2, 24.0},   {40, 99, 0, 99.0},     {40, 100, 0, 100.0},      {40, 101, 0, 100.0},
             {500, 50, 0, 50.0},    {500, 51, 0, 51.0},    {500, 30000, 0, 30000.0}, {500, 29999, 0, 29999.0},
             {500, 501, 1, 50.1},   {500, 499, 1, 50.0},   {500, 51, 4, 50.0},       {500, 0, 4, 0.0}}) {
        SCOPED_TRACE(fmt::format("type {}, {} with {} digits", one.type, one.integer, one.digits));
        make(1, one.type);
        set8(0x6332, 1, own_digits.at(one.type));
        override_with(one.integer);
        set8(0x6332, 1, one.digits);
        pass(1);
        const std::map<int, float> driven{{10, volts(1)}, {20, milliamperes(1)}, {40, duty(1)}, {500, hertz(1)}};
        EXPECT_FLOAT_EQ(driven.at(one.type), static_cast<float>(one.driven));
    }
}

TEST_F(Ax130751Edges, FeedbackValueIsClampedTo16Bits) {
    verifies<req::AOR_OUT_017>();
    // The frequency is 50 Hz or more; with three decimal digits (6332h = 3), 7330h and 2370h would read 50,000 or more.
    make(1, 500);
    set8(0x6332, 1, 3);
    command(1, 1000);
    EXPECT_EQ(get16(0x7330, 1), 32767);
    EXPECT_EQ(get16(0x2370, 1), 32767);
    set8(0x6332, 1, 2);
    set16(0x7323, 1, 32767);
    command(1, 30000);  // commands 327.67 Hz
    EXPECT_EQ(get16(0x7330, 1), 32767);
    set16(0x7323, 1, 32766);
    pass(1);
    EXPECT_EQ(get16(0x7330, 1), 32766);
}

TEST_F(Ax130751Edges, ControlResponsesClampOrSwitchOffExactlyBelowScaling1AndAboveScaling2) {
    verifies<req::AOR_OUT_003, req::AOR_OUT_006, req::AOR_OUT_031, req::AOR_T06>();
    make(2, 10);
    set16(0x7323, 2, 4000);
    set16(0x7321, 2, 1000);
    set16(0x7322, 2, 4000);
    set16(0x7320, 2, 1000);
    const auto millivolts = [this](int response, int value) {
        set8(0x2342, 2, response);
        command(2, value);
        return get16(0x2370, 2);
    };
    for (int response = 0; response <= 2; ++response) {
        EXPECT_EQ(millivolts(response, 999), response == 1 ? 0 : 1000) << response;
        EXPECT_EQ(millivolts(response, 1000), 1000) << response;
        EXPECT_EQ(millivolts(response, 1001), 1001) << response;
        EXPECT_EQ(millivolts(response, 3999), 3999) << response;
        EXPECT_EQ(millivolts(response, 4000), 4000) << response;
        EXPECT_EQ(millivolts(response, 4001), response == 2 ? 0 : 4000) << response;
    }
}

TEST_F(Ax130751Edges, AnalogueControlSwitchesADigitalOutputOnAtScaling2AndOffAtScaling1) {
    verifies<req::AOR_DO_002, req::AOR_SRC_007, req::AOR_SRC_016>();
    make(2, 1020);
    set8(0x2340, 2, canopen);
    set8(0x2341, 2, 7);  // number 7 is 2500h:4 (EC Extra Received Process Value)
    set8(0x2502, 4, 3);
    set16(0x2522, 4, 8000);  // the limits are 1.000 to 8.000
    set16(0x2520, 4, 1000);
    const auto is_on_at = [this](int thousandths) {
        extra(4, thousandths);
        return is_on(2);
    };
    EXPECT_FALSE(is_on_at(7999));
    EXPECT_TRUE(is_on_at(8000));
    EXPECT_TRUE(is_on_at(7999));
    EXPECT_TRUE(is_on_at(1001));
    EXPECT_FALSE(is_on_at(1000));
    EXPECT_FALSE(is_on_at(1001));
}

TEST_F(Ax130751Edges, RampAndBlinkTimesAreExactToAMillisecond) {
    verifies<req::AOR_OUT_012, req::AOR_DO_010, req::AOR_K_CYCLE>();
    set16(0x2330, 2, 2000);
    set16(0x2331, 2, 500);
    command(2, 5000);
    pass(1999);
    EXPECT_FLOAT_EQ(volts(2), 4.9975F);
    pass(1);
    EXPECT_FLOAT_EQ(volts(2), 5.0F);
    command(2, 0);
    pass(499);
    EXPECT_FLOAT_EQ(volts(2), 0.01F);
    pass(1);
    EXPECT_FLOAT_EQ(volts(2), 0.0F);
    make(2, 1020);
    set8(0x2241, 2, 3);
    set8(0x6220, 2, 1);
    pass(1);
    pass(499);
    EXPECT_TRUE(is_on(2)) << "500 ms as shipped";
    pass(1);
    EXPECT_FALSE(is_on(2));
}

// --- blocks (1.5 to 1.7) -------------------------------------------------------------------------------------------

TEST_F(Ax130751Edges, OutputOfATableWithLimitsWithin0To100IsTakenAsPercent) {
    verifies<req::AOR_LT_007, req::AOR_K_PERCENT_LOW, req::AOR_K_PERCENT_HIGH>();
    // Table 1 gives 50.00; logic block 1 shows this value as a percentage of the limits of the table.
    extra_as_percent(1);
    set8(0x3010, 0, canopen);
    set8(0x3011, 0, 4);
    set8(0x3014, 0, 2);
    for (int point = 1; point <= 10; ++point) {
        set16(0x3017, point, 5000);
    }
    set8(0x3300, 1, 1);
    const auto tenths = [this](int least, int greatest) {
        set16(0x3017, 10, least);
        set16(0x3017, 11, greatest);
        pass(2);
        return get16(0x3320, 1);
    };
    EXPECT_EQ(tenths(4000, 10000), 500) << "0 to 100";
    EXPECT_EQ(tenths(4000, 10001), 167) << "40 to 100.01: 10 of 60.01";
    EXPECT_EQ(tenths(0, 9999), 500);
    EXPECT_EQ(tenths(-1, 7500), 667) << "-0.01 to 75: 50.01 of 75.01";
}

TEST_F(Ax130751Edges, TimeIntervalOfALookupTablePointIsAtLeastOneMillisecond) {
    verifies<req::AOR_LT_011, req::AOR_K_SHORTEST_INTERVAL>();
    // X of 0 and below in data response become intervals of 1 ms when the response changes to time.
    set32(0x3016, 1, -5);
    for (int point = 2; point <= 4; ++point) {
        set32(0x3016, point, point - 4);  // X is -2, -1, 0
        set16(0x3017, point, 10 * point);
    }
    set8(0x3015, 5, 0);
    set8(0x3015, 1, 1);
    extra_as_percent(1);
    set8(0x3010, 0, canopen);
    set8(0x3011, 0, 4);
    extra(1, 100);
    EXPECT_EQ(get16(0x3018, 0), 0);
    for (int point = 2; point <= 4; ++point) {
        pass(1);
        EXPECT_EQ(get16(0x3018, 0), 10 * point);
    }
    pass(1);
    EXPECT_EQ(get16(0x3018, 0), 40);
}

TEST_F(Ax130751Edges, LogicalOperatorReadsAMathInputOfHalfScaleOrMoreAsTrue) {
    verifies<req::AOR_MATH_012, req::AOR_K_TRUE_FROM>();
    make_math(8);  // operator 8: and
    EXPECT_EQ(math_of(5000, 5000), 10000);
    EXPECT_EQ(math_of(4999, 5000), 0);
    EXPECT_EQ(math_of(5000, 4999), 0);
}

TEST_F(Ax130751Edges, MathGainOfOneIsWrittenAs100) {
    verifies<req::AOR_K_GAIN_ONE, req::AOR_MATH_019>();
    make_math(12);  // operator 12: plus
    set8(0x4140, 1, 99);
    EXPECT_EQ(math_of(10000, 0), 9900);
    set8(0x4140, 1, 100);
    EXPECT_EQ(math_of(9999, 0), 9999);
    set8(0x4140, 1, 1);
    EXPECT_EQ(math_of(10000, 0), 100);
}

TEST_F(Ax130751Edges, MathInputsAreClampedBelowInputScaling1AndAboveInputScaling2) {
    verifies<req::AOR_MATH_001, req::AOR_MATH_008, req::AOR_MATH_017>();
    make_math(17);  // operator 17: maximum
    set16(0x4120, 1, 2000);
    set16(0x4122, 1, 4000);
    EXPECT_EQ(math_of(1999, 0), 0);
    EXPECT_EQ(math_of(2001, 0), 5);  // 2001 is 1 above the lower scaling 2000; the span is 2000: 1 / 2000 = 0.0005
    EXPECT_EQ(math_of(3999, 0), 9995);
    EXPECT_EQ(math_of(4000, 0), 10000);
    EXPECT_EQ(math_of(4001, 0), 10000);
}

}  // namespace canproof::test
