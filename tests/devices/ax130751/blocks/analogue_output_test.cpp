// SPDX-License-Identifier: Apache-2.0
// Tests the analogue output block of the AX130751 (manual, 1.3), and the priorities of its inputs in Figure 4.
#include "devices/ax130751/firmware/analogue_output.hpp"

#include <cmath>

#include "devices/ax130751/firmware/current_loop.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/blocks/at.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

constexpr OutputRange volts{-10.0, 10.0};
constexpr OutputRange hertz{50.0, 30000.0};
const RampTimes slow{5.0, milliseconds(1000), milliseconds(1000)};  // ramps of 5 V/s
const RampTimes none{5.0, milliseconds(0), milliseconds(0)};
constexpr AnalogueDemand demand{4.0, 2.0, 1.0};  // field values in V: of the control, of the override, and in a fault

/// Returns which value drives the output (OutputDrive) under these conditions.
OutputDrive chosen(bool shutdown, bool in_error, OutputDrive on_error, bool overridden, OutputDrive enable) {
    return choose_drive(OutputConditions{shutdown, in_error, on_error, overridden, enable});
}

}  // namespace

TEST(OutputPriority, ShutdownPrecedesOverrideWhichPrecedesEnableWhichPrecedesError) {
    verifies<req::AOR_OUT_007, req::AOR_OUT_029, req::AOR_OUT_033>();
    const auto fault = OutputDrive::fault_value;
    EXPECT_EQ(chosen(true, true, fault, true, OutputDrive::keep), OutputDrive::shutdown);
    EXPECT_EQ(chosen(true, false, fault, false, OutputDrive::control), OutputDrive::shutdown);
    EXPECT_EQ(chosen(false, true, fault, true, OutputDrive::shut_off), OutputDrive::override_value);
    EXPECT_EQ(chosen(false, true, OutputDrive::keep, true, OutputDrive::control), OutputDrive::override_value);
    EXPECT_EQ(chosen(false, true, fault, false, OutputDrive::shut_off), OutputDrive::shut_off);
    EXPECT_EQ(chosen(false, true, fault, false, OutputDrive::ramp_off), OutputDrive::ramp_off);
    EXPECT_EQ(chosen(false, true, fault, false, OutputDrive::keep), OutputDrive::keep);
    EXPECT_EQ(chosen(false, true, fault, false, OutputDrive::control), OutputDrive::fault_value);
    EXPECT_EQ(chosen(false, true, OutputDrive::keep, false, OutputDrive::control), OutputDrive::keep);
    EXPECT_EQ(chosen(false, false, fault, true, OutputDrive::shut_off), OutputDrive::override_value);
    EXPECT_EQ(chosen(false, false, fault, false, OutputDrive::shut_off), OutputDrive::shut_off);
    EXPECT_EQ(chosen(false, false, fault, false, OutputDrive::ramp_off), OutputDrive::ramp_off);
    EXPECT_EQ(chosen(false, false, fault, false, OutputDrive::keep), OutputDrive::keep);
    EXPECT_EQ(chosen(false, false, fault, false, OutputDrive::control), OutputDrive::control);
}

TEST(AnalogueOutput, UnderNormalControlTheTargetJumpsAndTheOutputRampsToIt) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_017, req::AOR_OUT_018>();
    AnalogueOutput output;
    const auto first = output.advance(OutputDrive::control, demand, volts, slow, at(0));
    EXPECT_DOUBLE_EQ(first.target, 4.0);
    EXPECT_DOUBLE_EQ(first.value, 0.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(400)).value, 2.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(800)).value, 4.0);
}

TEST(AnalogueOutput, OverrideValueFaultValueAndShutOffTakeEffectWithoutARamp) {
    verifies<req::AOR_OUT_010, req::AOR_OUT_011, req::AOR_OUT_009, req::AOR_OUT_014, req::AOR_OUT_015>();
    AnalogueOutput output;
    output.advance(OutputDrive::control, demand, volts, none, at(0));
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::override_value, demand, volts, slow, at(1)).value, 2.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::fault_value, demand, volts, slow, at(2)).value, 1.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::shut_off, demand, volts, slow, at(3)).value, 0.0);
    output.advance(OutputDrive::override_value, demand, volts, slow, at(4));
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::shutdown, demand, volts, slow, at(5)).value, 0.0);
}

TEST(AnalogueOutput, AfterAnOverrideTheOutputRampsFromItsPresentValue) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_014>();
    AnalogueOutput output;
    output.advance(OutputDrive::override_value, demand, volts, slow, at(0));
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(10)).value, 2.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(210)).value, 3.0);
}

TEST(AnalogueOutput, AfterAFaultValueTheOutputRampsFromItsPresentValue) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_014>();
    AnalogueOutput output;
    output.advance(OutputDrive::fault_value, demand, volts, slow, at(0));
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(10)).value, 1.0);
    // 5 V/s for 200 ms are 1 V.
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(210)).value, 2.0);
}

TEST(AnalogueOutput, RampOffResponseLowersTheOutputAndKeepResponseFreezesIt) {
    verifies<req::AOR_OUT_009>();
    AnalogueOutput output;
    output.advance(OutputDrive::override_value, demand, volts, slow, at(0));
    const auto falling = output.advance(OutputDrive::ramp_off, demand, volts, slow, at(0));
    EXPECT_DOUBLE_EQ(falling.target, 0.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::ramp_off, demand, volts, slow, at(100)).value, 1.5);
    const auto kept = output.advance(OutputDrive::keep, demand, volts, slow, at(200));
    EXPECT_DOUBLE_EQ(kept.value, 1.0);
    EXPECT_DOUBLE_EQ(kept.target, 1.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::keep, demand, volts, slow, at(900)).value, 1.0);
}

TEST(AnalogueOutput, OutputStaysInTheRangeOfItsType) {
    verifies<req::AOR_OUT_016>();
    AnalogueOutput output;
    const AnalogueDemand far{11.0, -12.0, 99.0};
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, far, volts, none, at(0)).value, 10.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::override_value, far, volts, none, at(0)).value, -10.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::fault_value, far, volts, none, at(0)).value, 10.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, {23.0, 0.0, 0.0}, {0.0, 24.0}, none, at(0)).value, 23.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, {25.0, 0.0, 0.0}, {0.0, 24.0}, none, at(0)).value, 24.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::keep, far, {0.0, 1.0}, none, at(0)).value, 1.0);
}

TEST(AnalogueOutput, ValueThatIsNanPutsTheOutputOff) {
    verifies<req::AOR_OUT_016>();
    for (const OutputRange& range : {volts, hertz, OutputRange{0.0, 24.0}}) {
        AnalogueOutput output;
        const AnalogueDemand unknown{std::nan(""), std::nan(""), std::nan("")};
        EXPECT_DOUBLE_EQ(output.advance(OutputDrive::override_value, {0.0, 60.0, 0.0}, range, none, at(0)).value,
                         range.nearest(60.0));
        EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, unknown, range, none, at(1)).value, 0.0);
        EXPECT_DOUBLE_EQ(output.advance(OutputDrive::override_value, unknown, range, none, at(2)).value, 0.0);
        EXPECT_DOUBLE_EQ(output.advance(OutputDrive::fault_value, unknown, range, slow, at(3)).target, 0.0);
    }
}

TEST(AnalogueOutput, FrequencyIsOffOrAtLeastFiftyHertz) {
    verifies<req::AOR_OUT_034, req::AOR_OUT_015>();
    AnalogueOutput output;
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, {0.0, 0.0, 0.0}, hertz, none, at(0)).value, 0.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, {1.0, 0.0, 0.0}, hertz, none, at(0)).value, 50.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, {50.0, 0.0, 0.0}, hertz, none, at(0)).value, 50.0);
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, {-7.0, 0.0, 0.0}, hertz, none, at(0)).value, 0.0);
}

TEST(AnalogueOutput, ResetPutsTheOutputOff) {
    verifies<req::AOR_OUT_023>();
    AnalogueOutput output;
    output.advance(OutputDrive::control, demand, volts, none, at(0));
    output.reset();
    EXPECT_DOUBLE_EQ(output.advance(OutputDrive::control, demand, volts, slow, at(1)).value, 0.0);
}

TEST(CurrentLoop, CurrentIsLimitedByTheLoopVoltage) {
    verifies<req::AOR_OUT_019>();
    EXPECT_DOUBLE_EQ(loop_current(20.0, 250.0, 14.0, 1000.0), 20.0);
    EXPECT_DOUBLE_EQ(loop_current(20.0, 700.0, 14.0, 1000.0), 20.0);   // 700 Ohm * 20 mA = 14 V: just enough
    EXPECT_DOUBLE_EQ(loop_current(20.0, 1000.0, 14.0, 1000.0), 14.0);  // 14 V / 1 kOhm
    EXPECT_DOUBLE_EQ(loop_current(20.0, 0.0, 14.0, 1000.0), 20.0);
}

}  // namespace canproof::test
