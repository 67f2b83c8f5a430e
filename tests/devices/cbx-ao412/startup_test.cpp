// SPDX-License-Identifier: Apache-2.0
// Switches, self-start and program objects of the CAN-CBX-AO412 (manual, 3.3, 7.9.22, 7.9.23, 7.12).
#include <fmt/format.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

using CbxStartup = CbxTest;

TEST_F(CbxStartup, NodeIdComesFromTheTwoSwitches) {
    verifies<req::AO4_SW_001, req::AO4_SW_004, req::AO4_S_SWITCH_HIGH, req::AO4_S_SWITCH_LOW>();
    inputs.switch_high = 7;
    inputs.switch_low = 15;
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    inputs.switch_high = 0;
    inputs.switch_low = 1;
    set_inputs();
    EXPECT_EQ(send("67F#4000100000000000").size(), 1U);  // the new setting of the switches counts only after the next
                                                         // power-on
    EXPECT_TRUE(send("601#4000100000000000").empty());
    EXPECT_EQ(power_on(), (Frames{"701#00"}));
}

TEST_F(CbxStartup, InvalidNodeIdKeepsTheModuleSilent) {
    verifies<req::AO4_SW_002>();
    for (const int node_id : {0x00, 0x80, 0xFF}) {
        inputs.switch_high = static_cast<std::uint8_t>(node_id / 16);
        inputs.switch_low = static_cast<std::uint8_t>(node_id % 16);
        EXPECT_TRUE(power_on().empty());
        EXPECT_TRUE(send("000#0100").empty());
        EXPECT_TRUE(send(fmt::format("{:03X}#4000100000000000", 0x600 + node_id)).empty());
        EXPECT_TRUE(pass(2000).empty());
        EXPECT_EQ(volts(1), 0.0F);
    }
}

// Section 7.9.18: 'A' is 41h, 'K' 4Bh, 'Z' 5Ah; bit 7 is also set, and the digits are BCD
TEST_F(CbxStartup, SerialNumberIsTwoLettersAndFourDigits) {
    verifies<req::AO4_ID_001, req::AO4_OD_1018>();
    EXPECT_EQ(send("603#4018100400000000"), (Frames{"583#431810040501C2C1"}));  // serial number AB 0105
    factory.serial_number = 0xCBDA9387;
    power_on();
    EXPECT_EQ(send("603#4018100400000000"), (Frames{"583#431810048793DACB"}));  // serial number KZ 9387
}

TEST_F(CbxStartup, BitRateFollowsTable11) {
    verifies<req::AO4_SW_003, req::AO4_T11, req::AO4_S_SWITCH_BAUD>();
    // Table 11 gives these values in kbit/s; here they are in bit/s, and thirds and sixths are rounded to integers.
    const std::vector<std::uint32_t> rates{1000000, 666667, 500000, 333333, 250000, 166000, 125000, 100000,
                                           66667,   50000,  33333,  20000,  12500,  10000,  800000, 83333};
    for (std::size_t setting = 0; setting < rates.size(); ++setting) {
        inputs.switch_baud = static_cast<std::uint8_t>(setting);
        power_on();
        EXPECT_EQ(device->bit_rate(), rates[setting]) << setting;
    }
}

TEST_F(CbxStartup, ModuleStartsItselfAfterTheDelay) {
    verifies<req::AO4_START_001, req::AO4_OD_1F80, req::AO4_OD_1F91>();
    write("603#23801F0008000000");
    write("603#2310100173617665");
    power_on();
    pass(99);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
    send("000#8003");
    write("603#2B911F01F4010000");  // 1F91h:1 self-start delay: 500 ms
    write("603#2310100173617665");
    power_on();
    pass(499);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(CbxStartup, ModuleWaitsForTheMasterByDefault) {
    verifies<req::AO4_START_005>();
    pass(10000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(CbxStartup, ModuleWithStored2InNmtStartup1F80hWaitsUntilTheMasterStartsIt) {
    verifies<req::AO4_START_005>();
    write("603#23801F0008000000");
    write("603#2310100173617665");
    write("603#23801F0002000000");
    write("603#2310100173617665");
    power_on();
    pass(10000);  // the self-start delay is 100 ms
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    send("000#0103");
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(CbxStartup, NmtStartup1F80hAcceptsOnly2And8) {
    verifies<req::AO4_START_002, req::AO4_OD_1F80>();
    for (const char* value : {"00000000", "01000000", "04000000", "0A000000", "02000080"}) {
        EXPECT_EQ(send(std::string{"603#23801F00"} + value), (Frames{"583#80801F0030000906"})) << value;
    }
    write("603#23801F0008000000");
    write("603#23801F0002000000");
}

TEST_F(CbxStartup, NmtCommandCancelsTheSelfStart) {
    verifies<req::CO_NMT_008, req::AO4_START_003>();
    write("603#23801F0008000000");
    write("603#2310100173617665");
    power_on();
    pass(50);
    send("000#8003");
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    power_on();
    pass(50);
    send("000#8004");  // a command for another node
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(CbxStartup, ProgramDataIsRefusedOutsideTheBootLoader) {
    verifies<req::AO4_PROG_001, req::AO4_OD_1F50>();
    EXPECT_EQ(send("603#40501F0000000000"), (Frames{"583#80501F0022000008"}));
    EXPECT_EQ(send("603#21501F0000010000"), (Frames{"583#80501F0022000008"}));
    EXPECT_EQ(send("603#23501F0001020304"), (Frames{"583#80501F0022000008"}));
}

TEST_F(CbxStartup, ProgramControl1F51hKeepsTheWrittenValue) {
    verifies<req::CO_SDO_040, req::AO4_PROG_002, req::AO4_PROG_004, req::AO4_OD_1F51>();
    write("603#2F511F01FE000000");
    EXPECT_EQ(send("603#40511F0100000000"), (Frames{"583#4F511F01FE000000"}));
    EXPECT_EQ(send("603#2F511F01FF000000"), (Frames{"583#80511F0130000906"}));
}

TEST_F(CbxStartup, ProgramControl1F51hRefusesFFhAndKeepsItsValue) {
    verifies<req::AO4_PROG_004>();
    write("603#2F511F0101000000");
    EXPECT_EQ(send("603#2F511F01FF000000"), (Frames{"583#80511F0130000906"}));
    EXPECT_EQ(send("603#40511F0100000000"), (Frames{"583#4F511F0101000000"}));
}

TEST_F(CbxStartup, ProgramControl1F51hAlsoKeepsTheValues0And1) {
    verifies<req::AO4_PROG_002>();
    for (const std::string value : {"01", "00"}) {
        write("603#2F511F01" + value + "000000");
        EXPECT_EQ(send("603#40511F0100000000"), (Frames{"583#4F511F01" + value + "000000"}));
    }
}

TEST_F(CbxStartup, DateOfTheFirmwareIsReadOnly) {
    verifies<req::AO4_PROG_003, req::AO4_PROG_005, req::AO4_OD_1F52>();
    // 2014-11-24 is 11,285 days after 1984-01-01: 30 years with 8 leap days are 10,958 days; 327 days of 2014 follow.
    EXPECT_EQ(10958 + 327, 11285);
    EXPECT_EQ(send("603#40521F0100000000"), (Frames{"583#43521F01152C0000"}));  // 11285 = 2C15h
    EXPECT_EQ(send("603#40521F0200000000"), (Frames{"583#43521F0200000000"}));
    EXPECT_EQ(send("603#23521F0100000000"), (Frames{"583#80521F0102000106"}));
    EXPECT_EQ(send("603#23521F0200000000"), (Frames{"583#80521F0202000106"}));
}

TEST_F(CbxStartup, ResetRestartsTheDelayOfTheSelfStart) {
    verifies<req::AO4_START_006>();
    write("603#23801F0008000000");
    write("603#2310100173617665");
    power_on();
    for (const char* reset : {"000#8103", "000#8203"}) {
        pass(50);
        send(reset);
        pass(99);
        EXPECT_EQ(device->state(), NmtState::pre_operational) << reset;
        pass(1);
        EXPECT_EQ(device->state(), NmtState::operational) << reset;
    }
}

/// The supply is cut and returns, with other positions of the switches: power_on() restarts the same device object.
TEST_F(CbxStartup, DeviceThatHasRunIsSilentAfterPowerOnWithAnInvalidNodeId) {
    verifies<req::AO4_SW_002>();
    write("603#2344640100000020");  // 6444h:1 error value: 2000h in the upper 16 bits
    write("603#2B17100064000000");  // 1017h producer heartbeat time: 100 ms
    send("000#0103");
    inputs.switch_high = 8;  // node-ID 83h
    device->power_on(inputs, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(send("000#0103"), Frames{});
    EXPECT_EQ(send("603#2B11640100200000"), Frames{});  // 6411h:1 = 2000h
    EXPECT_EQ(pass(1000), Frames{});
    inputs.hardware_fault = true;
    inputs.can_overrun = true;
    inputs.can_state = 2;
    EXPECT_EQ(set_inputs(), Frames{});
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(device->state(), NmtState::initialising);
    EXPECT_EQ(volts(1), 0.0F);
}

namespace {

/// Returns the NMT state after the delay of the self-start; `reaction` is the value of 1029h:1 (error behaviour). The
/// CAN controller is bus-off before the boot-up, or from 50 ms after it.
NmtState started_in_bus_off(const std::string& reaction, bool before_boot_up) {
    CbxBench bench;
    bench.power_on();
    bench.write("603#2F291001" + reaction + "000000");
    bench.write("603#23801F0008000000");
    bench.write("603#2310100173617665");
    bench.inputs.can_state = before_boot_up ? 3 : 0;
    bench.power_on();
    bench.pass(50);
    bench.inputs.can_state = 3;
    bench.set_inputs();
    bench.pass(1000);
    return bench.device->state();
}

}  // namespace

TEST(CbxStartupInError, SelfStartWithBusOffLeadsToTheStateOfErrorBehaviour1029h) {
    verifies<req::CO_NMT_010, req::CO_NMT_011, req::AO4_START_004>();
    for (const bool before_boot_up : {false, true}) {
        EXPECT_EQ(started_in_bus_off("00", before_boot_up), NmtState::pre_operational);
        EXPECT_EQ(started_in_bus_off("01", before_boot_up), NmtState::operational);
        EXPECT_EQ(started_in_bus_off("02", before_boot_up), NmtState::stopped);
    }
}

/// The stored value of each output is 2000h = 8192, and its 6443h (error mode) is 2, unchanged: power-on in bus-off
/// leaves the output at 0 V until a client writes its value after the recovery.
TEST(CbxBusOff, PowerOnDuringBusOffLeavesTheOutputsAt0V) {
    verifies<req::AO4_AOUT_010, req::AO4_AOUT_013, req::AO4_AOUT_008>();
    CbxBench bench;
    bench.power_on();
    const auto set = [&bench](int output) { bench.write("603#2B11640" + std::to_string(output) + "00200000"); };
    for (int output = 1; output <= 4; ++output) {
        set(output);
        bench.write("603#2F43640" + std::to_string(output) + "02000000");
    }
    bench.write("603#2310100173617665");
    bench.inputs.can_state = 3;
    bench.power_on();
    for (int output = 1; output <= 4; ++output) {
        EXPECT_EQ(bench.volts(output), 0.0F) << output;
    }
    bench.inputs.can_state = 0;
    bench.set_inputs();
    for (int output = 1; output <= 4; ++output) {
        EXPECT_EQ(bench.volts(output), 0.0F) << output;
        set(output);
        EXPECT_NEAR(bench.volts(output), 1024 * 0.001 * 30.9 / 12.4, 0.001) << output;  // 1024 steps
    }
}

/// During bus-off the boot-up message is lost. The errors found at boot-up are reported after bus-off: error passive,
/// software failure, then the recovery from bus-off.
TEST(CbxBusOff, FailureFoundDuringBusOffIsReportedAfterBusOff) {
    verifies<req::AO4_ERR_011, req::AO4_ERR_019>();
    CbxBench bench;
    bench.inputs.can_state = 3;
    bench.inputs.internal_fault = true;
    EXPECT_EQ(bench.power_on(), Frames{});
    EXPECT_EQ(bench.pass(500), Frames{});
    bench.inputs.can_state = 0;
    EXPECT_EQ(bench.set_inputs(),
              (Frames{"083#2081110200000000", "083#1061110200000000", "083#4081110300000000", "083#0000010300000000"}));
}

/// Bus-off begins together with the failure. Its message cannot be sent during bus-off, but it must not be lost.
TEST(CbxBusOff, FailureThatBeginsWithBusOffIsReportedAfterBusOff) {
    verifies<req::AO4_ERR_019>();
    CbxBench bench;
    bench.power_on();
    bench.inputs.can_state = 3;
    bench.inputs.internal_fault = true;
    EXPECT_EQ(bench.set_inputs(), Frames{});
    bench.inputs.can_state = 0;
    const Frames frames = bench.set_inputs();
    EXPECT_EQ(std::count(frames.begin(), frames.end(), "083#1061110200000000"), 1);
}

}  // namespace canproof::test
