// SPDX-License-Identifier: Apache-2.0
// Analog outputs of the CAN-CBX-AO412 (manual, 4.3.1, 7.7, 7.10, 7.11), node 3.
#include <fmt/format.h>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

// One step is 1 mV * 30.9 / 12.4 = 2.49193… mV; full scale 4096 steps = 10.20697 V.
constexpr float step_v = 0.001F * 30.9F / 12.4F;

class CbxOutput : public CbxTest {
  protected:
    void set(int output, const std::string& value) { write("603#2B11640" + std::to_string(output) + value + "0000"); }
    void expect_steps(int output, int steps) { EXPECT_NEAR(volts(output), static_cast<float>(steps) * step_v, 1e-5F); }
};

}  // namespace

TEST_F(CbxOutput, ExamplesOfTheManualGivePlusAndMinusFiveVolts) {
    verifies<req::AO4_AOUT_001, req::AO4_K_REFERENCE, req::AO4_K_FEEDBACK, req::AO4_K_INPUT_RESISTOR, req::AO4_S_AOUT,
             req::AO4_OD_6411>();
    set(1, "B33E");  // 16051 / 8 = 2006.4: step 2006, 2006 * 2.49194 mV = 4.99882 V
    expect_steps(1, 2006);
    EXPECT_NEAR(volts(1), 5.0F, step_v);
    set(2, "4DC1");  // C14Dh is -16051
    expect_steps(2, -2006);
    EXPECT_NEAR(volts(2), -5.0F, step_v);
}

TEST_F(CbxOutput, OutputValuesRoundToStepsAsInTheTableOfSection7_10_2_2) {
    verifies<req::AO4_AOUT_002, req::AO4_K_CODES_PER_STEP>();
    const std::vector<std::pair<const char*, int>> rows{{"FBFF", -1}, {"FCFF", 0}, {"FFFF", 0},
                                                        {"0000", 0},  {"0300", 0}, {"0400", 1},
                                                        {"0B00", 1},  {"0C00", 2}, {"F3FF", -2}};
    for (const auto& [value, steps] : rows) {
        set(3, value);
        expect_steps(3, steps);
    }
    EXPECT_NEAR(step_v, 2.492e-3F, 1e-6F);
}

TEST_F(CbxOutput, OutputIsClampedTo4095Steps) {
    verifies<req::AO4_AOUT_003, req::AO4_K_DAC_STEPS>();
    set(1, "FF7F");
    expect_steps(1, 4095);
    EXPECT_NEAR(volts(1), 10.205F, 0.001F);
    set(1, "0080");
    expect_steps(1, -4095);
    write("603#2B042401FF7F0000");  // 2404h:1: calibration offset of nearly +10.24 V
    set(1, "FF7F");
    expect_steps(1, 4095);
}

TEST_F(CbxOutput, CalibrationScalesAndShiftsTheOutput) {
    verifies<req::AO4_AOUT_004, req::AO4_K_OFFSET_SCALE, req::AO4_K_GAIN_DIVISOR, req::AO4_OD_2404, req::AO4_OD_2405>();
    set(1, "0040");  // 16384 / 8 = 2048 steps
    expect_steps(1, 2048);
    write("603#2B05240100400000");  // gain 1 + 16384 / 262144 = 1.0625: 2048 * 1.0625 = 2176
    expect_steps(1, 2176);
    write("603#2B04240180000000");  // + 128 * 0.3125 mV = 40 mV = 16.05 steps
    expect_steps(1, 2192);
    write("603#2B05240100800000");  // gain 1 - 0.125: 1792 steps + 16.05
    expect_steps(1, 1808);
}

TEST_F(CbxOutput, OutputIsAlsoSetInPreOperational) {
    verifies<req::AO4_AOUT_005, req::AO4_AOUT_014>();
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    set(4, "0800");
    expect_steps(4, 1);
}

namespace {

class CbxOutputInError : public CbxOutput {
  protected:
    void SetUp() override {
        CbxOutput::SetUp();
        write("603#2F43640100000000");  // error mode of output 1: 0 V
        write("603#2F43640201000000");  // error mode of output 2: the error value
        write("603#2F43640302000000");  // error mode of output 3: unchanged
        write("603#2344640200000040");  // 40000000h: upper half 4000h = 16384 = 2048 steps
        send("000#0103");
        send("303#0020002000200020");  // 2000h = 8192: 1024 steps each
    }
    void expect_error_outputs() {
        expect_steps(1, 0);
        expect_steps(2, 2048);
        expect_steps(3, 1024);
        expect_steps(4, 0);  // default: error mode 1 (error value) and error value 0
    }
};

}  // namespace

TEST_F(CbxOutputInError, InternalFailureSetsEachOutputAccordingToItsErrorMode) {
    verifies<req::AO4_AOUT_006, req::AO4_AOUT_007, req::AO4_T_ERROR_MODE, req::AO4_OD_6443, req::AO4_OD_6444,
             req::AO4_S_INTERNAL_FAULT>();
    inputs.internal_fault = true;
    set_inputs();
    expect_error_outputs();
}

TEST_F(CbxOutputInError, HardwareFailureSetsEachOutputAccordingToItsErrorMode) {
    verifies<req::AO4_AOUT_006, req::AO4_AOUT_010, req::AO4_S_HARDWARE_FAULT>();
    inputs.hardware_fault = true;
    set_inputs();
    expect_error_outputs();
    inputs.internal_fault = true;  // an additional failure
    set_inputs();
    inputs.internal_fault = false;
    set_inputs();
    send("303#0010001000100010");  // the hardware failure is still active
    expect_error_outputs();
    send("000#8103");
    for (int output = 1; output <= 4; ++output) {
        expect_steps(output, 0);  // 6443h (error mode) is 1, 6444h (error value) is 0 by default
    }
}

TEST_F(CbxOutputInError, HeartbeatLossSetsEachOutputAccordingToItsErrorMode) {
    verifies<req::AO4_AOUT_006>();
    write("603#23161001C8003100");
    send("731#05");
    pass(300);
    expect_error_outputs();
}

TEST_F(CbxOutputInError, BusOffSetsEachOutputAccordingToItsErrorMode) {
    verifies<req::AO4_AOUT_006, req::AO4_S_CAN_STATE>();
    inputs.can_state = 3;
    set_inputs();
    expect_error_outputs();
}

TEST_F(CbxOutputInError, OverrunAndErrorPassiveDoNotChangeTheOutputs) {
    verifies<req::AO4_AOUT_006>();
    inputs.can_overrun = true;
    set_inputs();
    inputs.can_state = 2;
    set_inputs();
    for (int output = 1; output <= 4; ++output) {
        expect_steps(output, 1024);
    }
}

TEST_F(CbxOutputInError, SecondErrorWhileTheFirstLastsDoesNotChangeTheOutputs) {
    verifies<req::AO4_AOUT_006>();
    inputs.internal_fault = true;
    set_inputs();
    write("603#2344640200000060");  // this new error value is used only from the next error on
    inputs.can_state = 3;
    set_inputs();
    expect_error_outputs();
    inputs = {};
    inputs.switch_low = 3;
    set_inputs();
    expect_error_outputs();
    inputs.internal_fault = true;
    set_inputs();
    expect_steps(2, 3072);  // 6000h = 24576
}

TEST_F(CbxOutputInError, ErrorModeZeroVoltsIgnoresTheCalibration) {
    verifies<req::AO4_AOUT_006, req::AO4_T_ERROR_MODE>();
    write("603#2B04240180000000");  // + 128 * 0.3125 mV = 40 mV = 16.05 steps
    expect_steps(1, 1040);
    inputs.internal_fault = true;
    set_inputs();
    EXPECT_EQ(volts(1), 0.0F);
}

TEST_F(CbxOutputInError, ErrorValueStaysUntilTheNextWriteAfterTheError) {
    verifies<req::AO4_AOUT_008>();
    inputs.internal_fault = true;
    set_inputs();
    send("303#0010001000100010");  // this RPDO has no effect while the error is active
    expect_error_outputs();
    inputs.internal_fault = false;
    set_inputs();
    expect_error_outputs();
    send("000#0103");
    send("303#0010001000100010");  // 1000h = 4096: 512 steps
    for (int output = 1; output <= 4; ++output) {
        expect_steps(output, 512);
    }
}

TEST_F(CbxOutput, RestoreBringsBackTheFactoryCalibration) {
    verifies<req::AO4_AOUT_009, req::AO4_AOUT_012>();
    factory.offset = {10, 20, 30, 40};
    factory.gain = {-1, -2, -3, -4};
    power_on();
    const auto expect_factory_values = [this] {
        for (int output = 1; output <= 4; ++output) {  // 2404h (offset) is 10 to 40, 2405h (gain) is -1 to -4
            EXPECT_EQ(send(fmt::format("603#400424{:02X}00000000", output)),
                      (Frames{fmt::format("583#4B0424{:02X}{:02X}000000", output, 10 * output)}));
            EXPECT_EQ(send(fmt::format("603#400524{:02X}00000000", output)),
                      (Frames{fmt::format("583#4B0524{:02X}{:02X}FF0000", output, 0x100 - output)}));
        }
    };
    expect_factory_values();
    for (const char* group : {"01", "04"}) {
        for (int output = 1; output <= 4; ++output) {
            write(fmt::format("603#2B0424{:02X}63000000", output));
            write(fmt::format("603#2B0524{:02X}63000000", output));
        }
        write("603#2310100173617665");
        power_on();
        EXPECT_EQ(send("603#4004240200000000"), (Frames{"583#4B04240263000000"}));
        write(std::string{"603#231110"} + group + "6C6F6164");
        send("000#8103");
        expect_factory_values();
    }
}

TEST_F(CbxOutput, ResetCommunicationKeepsTheCalibration) {
    verifies<req::CO_NMT_006>();
    write("603#2B04240263000000");
    send("000#8203");
    EXPECT_EQ(send("603#4004240200000000"), (Frames{"583#4B04240263000000"}));
}

TEST_F(CbxOutputInError, NewCalibrationOffsetAppliesToThePresentOutputAtOnce) {
    verifies<req::AO4_AOUT_011, req::AO4_AOUT_008>();
    // 2404h (Calibration Offset Value) = 8 is 8 * 312.5 uV = 2.5 mV, one step of 2.492 mV.
    write("603#2B11640100200000");  // 2000h = 8192: 1024 steps
    expect_steps(1, 1024);
    write("603#2B04240108000000");
    expect_steps(1, 1025);
    inputs.internal_fault = true;
    set_inputs();
    expect_steps(2, 2048);  // the error value of output 2
    write("603#2B04240208000000");
    expect_steps(2, 2049);
    inputs.internal_fault = false;
    set_inputs();
    expect_steps(2, 2049);  // after the error, the output keeps the error value
    write("603#2B04240200000000");
    expect_steps(2, 2048);
    expect_steps(1, 0);  // 6443h:1 (error mode) is 0: output 1 is at 0 V, without a calibration offset
}

TEST_F(CbxOutputInError, NewCalibrationGainAppliesToThePresentOutputAtOnce) {
    verifies<req::AO4_AOUT_011>();
    // 2405h (Calibration Gain Value) = 256 multiplies the output by 1 + 256 / 262144 = 1025 / 1024.
    write("603#2B11640100200000");  // 2000h = 8192: 1024 steps
    write("603#2B05240100010000");
    expect_steps(1, 1025);
    inputs.internal_fault = true;
    set_inputs();
    expect_steps(2, 2048);          // the error value
    write("603#2B05240280000000");  // 128: 2048 * (1 + 128 / 262144) = 2049
    expect_steps(2, 2049);
}

TEST_F(CbxOutputInError, LowerTwoBytesOfTheErrorValueHaveNoEffect) {
    verifies<req::AO4_AOUT_007, req::AO4_AOUT_015>();
    // Up to 0003h, the upper half of the error value gives 0 V; 0004h gives one step.
    for (const auto& [value, steps] : {std::pair{"FFFF0300", 0}, std::pair{"00000400", 1}, std::pair{"FFFF0400", 1}}) {
        write(std::string{"603#23446402"} + value);
        inputs.internal_fault = true;
        set_inputs();
        expect_steps(2, steps);
        inputs.internal_fault = false;
        set_inputs();
    }
}

TEST_F(CbxOutput, StoredOutputValuesAreSetAtEveryOutputAtPowerOn) {
    verifies<req::AO4_OD_6411, req::AO4_STORE_003>();
    for (int output = 1; output <= 4; ++output) {
        set(output, "0020");  // 2000h = 8192: 1024 steps
    }
    write("603#2310100173617665");
    power_on();
    for (int output = 1; output <= 4; ++output) {
        expect_steps(output, 1024);
    }
}

TEST_F(CbxOutput, ResetDuringAnInternalFailureSetsEachOutputAccordingToItsErrorMode) {
    verifies<req::AO4_AOUT_010, req::AO4_AOUT_013>();
    write("603#2B11640100200000");
    write("603#2B11640200200000");
    write("603#2B11640300200000");
    write("603#2F43640100000000");  // error mode of output 1: 0 V
    write("603#2F43640201000000");  // error mode of output 2: the error value (6444h)
    write("603#2344640200000004");  // 6444h:2 (Analogue Output Error Value) = 0400h = 1024: 128 steps
    write("603#2F43640302000000");  // error mode of output 3: unchanged
    write("603#2310100173617665");
    inputs.internal_fault = true;
    set_inputs();
    send("000#8103");
    expect_steps(1, 0);
    expect_steps(2, 128);
    expect_steps(3, 1024);
    power_on();
    expect_steps(1, 0);
    expect_steps(2, 128);
    expect_steps(3, 0);  // output 3 has been at 0 V since power-on
}

/// The supply is cut and returns: power_on() restarts the same device object.
TEST_F(CbxOutput, PowerOnWithAFailureOrAnInvalidNodeIdStartsWithoutVoltage) {
    verifies<req::AO4_AOUT_010, req::AO4_AOUT_013, req::AO4_SW_002>();
    for (int output = 1; output <= 4; ++output) {
        write("603#2F43640" + std::to_string(output) + "02000000");  // error mode of the output: unchanged
    }
    write("603#2310100173617665");
    for (const bool has_node_id : {true, false}) {
        inputs = cbx_ao412::Inputs{};
        power_on();
        for (int output = 1; output <= 4; ++output) {
            set(output, "0020");  // 2000h = 8192: 1024 steps
            expect_steps(output, 1024);
        }
        inputs.hardware_fault = has_node_id;  // during a hardware failure, power-on does not set the stored values
        inputs.switch_high = has_node_id ? 0 : 8;
        device->power_on(inputs, now);
        sent();
        for (int output = 1; output <= 4; ++output) {
            EXPECT_EQ(volts(output), 0.0F) << output << has_node_id;
        }
    }
}

TEST_F(CbxOutput, ResetDuringAFailureAppliesTheStoredCalibration) {
    verifies<req::AO4_AOUT_004, req::AO4_AOUT_010>();
    for (int output = 1; output <= 4; ++output) {
        set(output, "0020");                                         // 2000h = 8192: 1024 steps
        write("603#2F43640" + std::to_string(output) + "02000000");  // error mode of the output: unchanged
    }
    write("603#2310100173617665");  // saves all parameters, also the calibration offset 0
    for (int output = 1; output <= 4; ++output) {
        write("603#2B04240" + std::to_string(output) + "08000000");  // 8 * 312.5 uV = 2.5 mV, one step
        expect_steps(output, 1025);
    }
    inputs.hardware_fault = true;
    set_inputs();
    for (int output = 1; output <= 4; ++output) {
        expect_steps(output, 1025);
    }
    send("000#8103");
    for (int output = 1; output <= 4; ++output) {
        expect_steps(output, 1024);
    }
}

TEST_F(CbxOutput, ResetDuringAHardwareFailureDoesNotApplyStoredOutputValues) {
    verifies<req::AO4_AOUT_013>();
    set(2, "0020");                 // 2000h = 8192: 1024 steps
    write("603#2310100173617665");  // 1010h:1 saves 6443h (error mode) = 1 and 6444h (error value) = 0
    inputs.hardware_fault = true;
    set_inputs();
    send("000#8103");
    expect_steps(2, 0);
}

/// Reset node clears 1016h: no producer is monitored, so a missing heartbeat is no error any more.
TEST_F(CbxOutputInError, ResetNodeEndsACommunicationError) {
    verifies<req::AO4_AOUT_006, req::CO_NMT_005>();
    write("603#23161001C8003100");
    send("731#05");
    pass(300);
    expect_error_outputs();
    inputs.internal_fault = false;
    set_inputs();
    set(1, "0010");  // has no effect: the heartbeat of the producer is still missing
    expect_error_outputs();
    send("000#8103");
    set(1, "0010");  // 1000h = 4096: 512 steps
    expect_steps(1, 512);
    inputs.can_overrun = true;
    set_inputs();
    expect_steps(1, 512);
    set(1, "0020");
    expect_steps(1, 1024);
}

TEST_F(CbxOutputInError, InternalFailureKeepsErrorValuesAtTheOutputsAfterACommunicationError) {
    verifies<req::AO4_AOUT_006>();
    write("603#23161001C8003100");
    inputs.internal_fault = true;
    set_inputs();
    send("731#05");
    pass(300);  // the heartbeat has been missing since 200 ms
    send("731#05");
    write("603#2B11640100100000");
    write("603#2B11640300100000");
    expect_error_outputs();
}

}  // namespace canproof::test
