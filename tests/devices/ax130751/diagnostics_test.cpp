// SPDX-License-Identifier: Apache-2.0
// Tests supply, temperature and errors of the AX130751 (manual, 1.8, 3.2.4, chapter 4).
#include <limits>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class Ax130751Diagnostics : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        no_ramps(1);
        no_ramps(2);
        set8(0x6220, 3, 1);
        set16(0x7300, 2, 4000);
        command(1, 2000);
    }
    Frames supply(float volts_supplied) {
        inputs.supply = volts_supplied;
        set_inputs();
        return pass(1);
    }
    Frames temperature(float degrees) {
        inputs.cpu_temperature = degrees;
        set_inputs();
        return pass(1);
    }
    bool all_run() const { return volts(1) == 2.0F && volts(2) == 4.0F && relay_on(); }
    bool all_off() const { return volts(1) == 0.0F && volts(2) == 0.0F && !relay_on(); }
    /// Returns whether the outputs are off and the coil of the relay has no current. In state OFF the coil has current;
    /// in state ON it has none.
    bool hardware_off() const { return volts(1) == 0.0F && volts(2) == 0.0F && device->outputs().relay_nc; }

    static constexpr float unknown = std::numeric_limits<float>::quiet_NaN();  ///< a value that cannot be measured
};

TEST_F(Ax130751Diagnostics, SupplyAndTemperatureAreMeasured) {
    verifies<req::AOR_DIAG_001, req::AOR_S_SUPPLY, req::AOR_S_TEMPERATURE>();
    EXPECT_FLOAT_EQ(get_real(0x5020), 24.0F);
    EXPECT_FLOAT_EQ(get_real(0x5030), 35.0F);
    supply(13.37F);
    temperature(-7.5F);
    EXPECT_FLOAT_EQ(get_real(0x5020), 13.37F);
    EXPECT_FLOAT_EQ(get_real(0x5030), -7.5F);
}

TEST_F(Ax130751Diagnostics, UnderVoltageFaultHasHysteresis) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_006, req::AOR_DIAG_009, req::AOR_DIAG_015>();
    supply(8.0F);
    EXPECT_TRUE(all_run()) << "at the threshold";
    supply(7.9F);
    EXPECT_TRUE(all_off());
    supply(12.9F);
    EXPECT_TRUE(all_off()) << "until 8 + 5 V";
    supply(13.0F);
    EXPECT_TRUE(all_run());
}

TEST_F(Ax130751Diagnostics, OverVoltageFaultHasHysteresis) {
    verifies<req::AOR_DIAG_003, req::AOR_DIAG_006, req::AOR_DIAG_016>();
    supply(35.0F);
    EXPECT_TRUE(all_run());
    supply(35.1F);
    EXPECT_TRUE(all_off());
    supply(30.1F);
    EXPECT_TRUE(all_off()) << "until 35 - 5 V";
    supply(30.0F);
    EXPECT_TRUE(all_run());
}

TEST_F(Ax130751Diagnostics, OverTemperatureFaultHasHysteresis) {
    verifies<req::AOR_DIAG_004, req::AOR_DIAG_006, req::AOR_DIAG_017>();
    temperature(85.0F);
    EXPECT_TRUE(all_run());
    temperature(85.1F);
    EXPECT_TRUE(all_off());
    temperature(60.1F);
    EXPECT_TRUE(all_off()) << "until 85 - 25 degrees";
    temperature(60.0F);
    EXPECT_TRUE(all_run());
}

TEST_F(Ax130751Diagnostics, FaultsFollowTheConfiguredThresholds) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_003, req::AOR_DIAG_004, req::AOR_DIAG_015, req::AOR_DIAG_016,
             req::AOR_DIAG_017>();
    set8(0x5022, 0, 20);
    set8(0x5023, 0, 28);
    set8(0x5024, 0, 1);
    set8(0x5032, 0, 50);
    set8(0x5033, 0, 10);
    pass(1);
    EXPECT_TRUE(all_run());
    supply(19.9F);
    EXPECT_TRUE(all_off());
    supply(21.0F);
    EXPECT_TRUE(all_run());
    supply(28.1F);
    EXPECT_TRUE(all_off());
    supply(27.0F);
    EXPECT_TRUE(all_run());
    temperature(51.0F);
    EXPECT_TRUE(all_off());
    temperature(40.0F);
    EXPECT_TRUE(all_run());
}

TEST_F(Ax130751Diagnostics, FaultEndsWhenItsDetectionIsSwitchedOff) {
    verifies<req::AOR_DIAG_005, req::AOR_DIAG_011, req::AOR_DIAG_018>();
    supply(7.5F);
    EXPECT_TRUE(all_off());
    set8(0x5021, 0, 0);
    pass(1);
    EXPECT_TRUE(all_run()) << "ends with its detection";
    set8(0x5021, 0, 1);
    supply(24.0F);
    temperature(100.0F);
    EXPECT_TRUE(all_off());
    set8(0x5031, 0, 0);
    pass(1);
    EXPECT_TRUE(all_run());
    EXPECT_EQ(read(0x1001, 0), 0U);
}

TEST_F(Ax130751Diagnostics, TemperatureThatIsNanIsATemperatureFault) {
    verifies<req::AOR_DIAG_004, req::AOR_DIAG_006, req::AOR_DIAG_017, req::AOR_DIAG_018, req::AOR_DIAG_019>();
    EXPECT_EQ(temperature(unknown), (Frames{"1:0FF#0042010000000000"}));
    EXPECT_TRUE(all_off());
    EXPECT_EQ(temperature(60.1F), Frames{});
    EXPECT_TRUE(all_off()) << "until 85 - 25 degrees";
    EXPECT_EQ(temperature(60.0F), (Frames{"1:0FF#0000000000000000"}));
    EXPECT_TRUE(all_run());
    temperature(86.0F);
    EXPECT_EQ(temperature(unknown), Frames{});
    EXPECT_TRUE(all_off()) << "NaN does not end the fault";
    set8(0x5031, 0, 0);
    pass(1);
    EXPECT_EQ(temperature(unknown), Frames{});
    EXPECT_TRUE(all_run()) << "no fault without its detection";
}

// Chapter 4: below 7 V and above 39 V the hardware switches the outputs off. 5022h (Under Voltage Threshold) is 0 here.
TEST_F(Ax130751Diagnostics, ShutdownByTheHardwareIsASupplyFault) {
    verifies<req::AOR_DIAG_022, req::AOR_DIAG_007, req::AOR_DIAG_012, req::AOR_DIAG_005>();
    set8(0x5022, 0, 0);
    EXPECT_EQ(supply(7.0F), Frames{});
    for (const float wrong : {6.99F, unknown}) {
        SCOPED_TRACE(wrong);
        EXPECT_EQ(supply(wrong), (Frames{"1:0FF#0031010000000000"}));
        EXPECT_EQ(read(0x1003, 1), 0x00003100U);
        EXPECT_TRUE(hardware_off());
        EXPECT_EQ(supply(7.0F), (Frames{"1:0FF#0000000000000000"})) << "without a hysteresis";
        EXPECT_TRUE(all_run());
    }
    set8(0x5021, 0, 0);
    for (const float wrong : {6.99F, 39.01F, unknown}) {
        EXPECT_EQ(supply(wrong), Frames{}) << "no fault without its detection";
        EXPECT_TRUE(hardware_off());
    }
}

TEST_F(Ax130751Diagnostics, OutputTakesItsFaultValueWhileTheTemperatureThatControlsItIsNan) {
    verifies<req::AOR_SRC_019, req::AOR_OUT_011, req::AOR_OUT_016>();
    set8(0x5034, 0, 0);  // the temperature fault does not shut the outputs down
    set16(0x7341, 1, 1500);
    set8(0x2341, 1, 1);
    set8(0x2340, 1, temperature_source);
    for (const int ramp : {0, 1000}) {
        SCOPED_TRACE(ramp);
        set16(0x2331, 1, ramp);
        temperature(35.0F);
        EXPECT_FLOAT_EQ(volts(1), 5.0F) << "35 degrees are above 7322h, which is 5";
        temperature(unknown);
        EXPECT_FLOAT_EQ(volts(1), 1.5F);
        EXPECT_EQ(get16(0x7330, 1), 1500);
        pass(5000);
        EXPECT_FLOAT_EQ(volts(1), 1.5F);
    }
}

TEST_F(Ax130751Diagnostics, LookupTableKeepsItsOutputWhileItsSupplyOrTemperatureIsNan) {
    verifies<req::AOR_SRC_019, req::AOR_LT_025>();
    set8(0x3010, 0, supply_source);  // by default, Y equals X in both tables
    set8(0x3020, 0, temperature_source);
    pass(1);
    EXPECT_EQ(get16(0x3018, 0), 24);
    EXPECT_EQ(get16(0x3028, 0), 35);
    supply(unknown);
    temperature(unknown);
    EXPECT_EQ(get16(0x3018, 0), 24);
    EXPECT_EQ(get16(0x3028, 0), 35);
    supply(12.0F);
    temperature(50.0F);
    EXPECT_EQ(get16(0x3018, 0), 12);
    EXPECT_EQ(get16(0x3028, 0), 50);
}

TEST_F(Ax130751Diagnostics, OutputsKeepRunningAtAFaultWithoutShutdown) {
    verifies<req::AOR_DIAG_006>();
    set8(0x5025, 0, 0);
    supply(7.5F);
    EXPECT_TRUE(all_run());
    EXPECT_EQ(read(0x1001, 0), 1U) << "but the fault is there";
    set8(0x5034, 0, 0);
    temperature(99.0F);
    EXPECT_TRUE(all_run());
    set8(0x5034, 0, 1);
    pass(1);
    EXPECT_TRUE(all_off());
}

TEST_F(Ax130751Diagnostics, HardwareProtectionActsOutside7To39VoltsEvenWithoutFaultDetection) {
    verifies<req::AOR_DIAG_008, req::AOR_K_SUPPLY_SHUTDOWN_LOW, req::AOR_K_SUPPLY_SHUTDOWN_HIGH>();
    set8(0x5021, 0, 0);
    supply(7.0F);
    EXPECT_TRUE(all_run());
    supply(6.9F);
    EXPECT_TRUE(hardware_off());
    supply(39.0F);
    EXPECT_TRUE(all_run());
    supply(39.1F);
    EXPECT_TRUE(hardware_off());
    supply(24.0F);
    EXPECT_TRUE(all_run());
    supply(std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(hardware_off()) << "what cannot be measured protects too";
}

TEST_F(Ax130751Diagnostics, ShutdownPrecedesTheOverrideOfOutputAndRelay) {
    verifies<req::AOR_OUT_007, req::AOR_RELAY_011, req::AOR_DIAG_006>();
    extra_as_percent(1);
    for (const std::uint16_t index : std::array<std::uint16_t, 2>{0x2360, 0x2290}) {
        set8(index, 1, canopen);
        set8(static_cast<std::uint16_t>(index + 1), 1, 4);
    }
    set16(0x2300, 1, 5000);
    set8(0x2293, 1, 1);
    extra(1, 100);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    supply(7.5F);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Diagnostics, OutputsRampFromOffAfterAShutdown) {
    verifies<req::AOR_DIAG_009, req::AOR_DIAG_020>();
    set16(0x2330, 1, 1000);
    supply(7.5F);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    supply(24.0F);
    pass(200);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);  // 1 V after 200 ms: the ramp rises by 5 V per second
    pass(1000);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
}

TEST_F(Ax130751Diagnostics, RelayRunsItsOnDelayAfterAHardwareShutdown) {
    verifies<req::AOR_DIAG_014>();
    set8(0x5021, 0, 0);
    set8(0x22A0, 1, 1);
    set32(0x22A1, 1, 50);  // the ON delay is 50 ms
    pass(50);
    for (const float sound : {7.0F, 39.0F}) {
        supply(sound);
        supply(24.0F);
        EXPECT_TRUE(relay_on()) << sound;
    }
    for (const float wrong : {6.99F, 39.01F, std::numeric_limits<float>::quiet_NaN()}) {
        SCOPED_TRACE(wrong);
        EXPECT_TRUE(relay_on());
        supply(wrong);
        supply(24.0F);  // the valid supply lets the relay go ON again, but only after its ON delay
        EXPECT_FALSE(relay_on());
        pass(49);
        EXPECT_FALSE(relay_on());
        pass(1);
        EXPECT_TRUE(relay_on());
    }
}

TEST_F(Ax130751Diagnostics, FaultsAreReportedByEmcyAndInTheErrorList) {
    verifies<req::AOR_DIAG_007, req::AOR_DIAG_012, req::AOR_DIAG_013, req::AOR_T_FAULT_CODES, req::AOR_DIAG_019,
             req::AOR_DIAG_021>();
    EXPECT_EQ(supply(7.5F), (Frames{"1:0FF#0031010000000000"}));
    EXPECT_EQ(read(0x1001, 0), 1U);
    EXPECT_EQ(temperature(99.0F), (Frames{"1:0FF#0042010000000000"}));
    EXPECT_EQ(read(0x1003, 0), 2U);
    EXPECT_EQ(read(0x1003, 1), 0x00004200U) << "the newest first";
    EXPECT_EQ(read(0x1003, 2), 0x00003100U);
    EXPECT_EQ(supply(24.0F), (Frames{"1:0FF#0000010000000000"}));
    EXPECT_EQ(read(0x1003, 0), 1U);
    EXPECT_EQ(temperature(20.0F), (Frames{"1:0FF#0000000000000000"}));
    EXPECT_EQ(read(0x1003, 0), 0U);
    EXPECT_EQ(read(0x1001, 0), 0U);
}

TEST_F(Ax130751Diagnostics, SupplyFaultIsReportedBeforeATemperatureFaultOfTheSameCycle) {
    verifies<req::AOR_DIAG_007, req::AOR_DIAG_012, req::AOR_DIAG_013, req::AOR_ERR_003, req::AOR_DIAG_019>();
    inputs.supply = 7.5F;
    EXPECT_EQ(temperature(99.0F), (Frames{"1:0FF#0031010000000000", "1:0FF#0042010000000000"}));
    EXPECT_EQ(read(0x1003, 1), 0x00004200U) << "the newest";
    EXPECT_EQ(read(0x1003, 2), 0x00003100U);
    inputs.supply = 24.0F;
    EXPECT_EQ(temperature(20.0F), (Frames{"1:0FF#0000010000000000", "1:0FF#0000000000000000"}));
}

TEST_F(Ax130751Diagnostics, FaultThatEndedBeforeTheNodeHasANodeIdIsNotReported) {
    verifies<req::AOR_DIAG_007, req::AOR_DIAG_019, req::CO_EMCY_009>();
    send("000#807F");
    send("7E5#0401");
    EXPECT_EQ(send("7E5#11FF"), (Frames{"7E4#110000"}));
    EXPECT_EQ(send("7E5#0400"), Frames{}) << "no node-ID, no boot-up";
    EXPECT_EQ(supply(7.5F), Frames{});
    EXPECT_TRUE(all_off());
    EXPECT_EQ(supply(24.0F), Frames{});
    EXPECT_EQ(temperature(99.0F), Frames{});
    send("7E5#0401");
    EXPECT_EQ(send("7E5#1120"), (Frames{"7E4#110000"}));
    EXPECT_EQ(send("7E5#0400"), (Frames{"720#00", "0A0#0042010000000000"})) << "only what is there now";
}

TEST_F(Ax130751Diagnostics, UnderAndOverVoltageCountAsOneFault) {
    verifies<req::AOR_DIAG_007, req::AOR_DIAG_012>();
    EXPECT_EQ(supply(7.5F).size(), 1U);
    EXPECT_EQ(supply(40.0F).size(), 0U) << "still a supply fault";
    EXPECT_EQ(supply(24.0F).size(), 1U);
}

TEST_F(Ax130751Diagnostics, EntriesOfTheErrorListFollowTable23) {
    verifies<req::AOR_DIAG_010, req::AOR_T23>();
    start();
    set16(0x1400, 5, 50);
    send("27F#0000000000");
    pass(60);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U);
    set32(0x1016, 3, 0x00220064);  // 1016h:3 consumer heartbeat time: node 22h, 100 ms
    send("722#05");
    pass(110);
    EXPECT_EQ(read(0x1003, 1), 0x80228130U);
    set16(0x100C, 0, 50);
    set8(0x100D, 0, 2);
    send("77F#R");
    pass(110);
    EXPECT_EQ(read(0x1003, 1), 0x10008130U);
    EXPECT_EQ(read(0x1003, 0), 3U);
    send("27F#0000000000");
    send("722#05");
    send("77F#R");
    EXPECT_EQ(read(0x1003, 0), 0U) << "each until it ends";
}

// Sections 1.8 and 3.4.86: a supply or temperature fault switches the outputs off but does not change the NMT state.
TEST_F(Ax130751Diagnostics, SupplyOrTemperatureFaultAtPowerOnStopsOutputsButNotTheSelfStart) {
    verifies<req::AOR_START_004, req::AOR_DIAG_006, req::AOR_DIAG_007>();
    set8(0x5555, 0, 1);
    set8(0x2342, 1, 0);
    set16(0x7321, 1, 2000);  // 7321h:1 (AO Output Scaling 1 FV): a control value of 0 gives 2 V
    store();
    const ax130751::Inputs sound = inputs;
    for (const bool hot : {false, true}) {
        SCOPED_TRACE(hot);
        inputs.supply = hot ? 24.0F : 7.5F;  // 7.5 V is below the fault threshold of 8 V, but above 7 V, where the
                                             // hardware shuts off
        inputs.cpu_temperature = hot ? 86.0F : 35.0F;
        EXPECT_EQ(power_on().at(1), hot ? "0FF#0042010000000000" : "0FF#0031010000000000");
        pass(2);
        EXPECT_EQ(device->state(), NmtState::operational);
        EXPECT_FLOAT_EQ(volts(1), 0.0F);
        inputs = sound;
        set_inputs();
        pass(2);
        EXPECT_FLOAT_EQ(volts(1), 2.0F);
    }
}

}  // namespace canproof::test
