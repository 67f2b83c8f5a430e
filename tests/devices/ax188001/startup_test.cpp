// SPDX-License-Identifier: Apache-2.0
// Tests the start of the AX188001 and its LSS (manual, 1.4, 3.1, 3.4.22, 3.4.23).
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001Startup : public TcsTest {
  protected:
    void start_with(std::uint32_t option) {
        EXPECT_EQ(write(0x5555, 0, 1, option), 0U);
        EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    }
};

class Ax188001LssSession : public TcsTest {
  protected:
    void talk(const std::vector<Exchange>& table) { test::talk(static_cast<TcsBench&>(*this), table); }
};

}  // namespace

TEST_F(Ax188001Startup, NodeWaitsForTheMasterAsShipped) {
    verifies<req::TCS_START_001, req::TCS_OD_5555, req::TCS_T3>();
    EXPECT_EQ(read(0x5555).value, 0U);
    EXPECT_EQ(read(0x5555).size, 1);
    EXPECT_EQ(pass(10000), Frames{});
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(write(0x5555, 0, 1, 3), too_high);
}

TEST_F(Ax188001Startup, StartMode1EntersOperationalAtOnce) {
    verifies<req::TCS_START_002, req::TCS_T3>();
    start_with(1);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(power_on(), (Frames{"77F#00", "1FF#A012A012"}));
    EXPECT_EQ(device->state(), NmtState::operational);
    const Frames frames = pass(5000);
    EXPECT_EQ(frames.size(), 5U);  // TPDO1 every second, and no NMT command from the device itself
    for (const char* reset : {"000#827F", "000#817F"}) {
        send("000#807F");
        EXPECT_EQ(device->state(), NmtState::pre_operational);
        send(reset);
        EXPECT_EQ(device->state(), NmtState::operational) << reset;
    }
}

TEST_F(Ax188001Startup, UnsavedWriteToStartInOperationalMode5555hStartsNothingAfterAResetOfTheCommunication) {
    verifies<req::TCS_START_001>();
    EXPECT_EQ(write(0x5556, 0, 2, 0), 0U);
    for (const std::uint32_t mode : {1U, 2U}) {
        EXPECT_EQ(write(0x5555, 0, 1, mode), 0U);
        for (const int group : {2, 3}) {  // communication and application parameters: not 5555h
            EXPECT_EQ(write(0x1010, group, 4, save), 0U);
        }
        EXPECT_EQ(send("000#827F"), (Frames{"77F#00"})) << mode;
        send("7E5#0401");
        EXPECT_EQ(send("7E5#0400"), (Frames{"77F#00"})) << mode;
        EXPECT_EQ(pass(5000), Frames{}) << mode;
        EXPECT_EQ(read(0x5555).value, mode) << "the written value stays readable";
        EXPECT_EQ(send("000#817F"), (Frames{"77F#00"})) << mode;
        EXPECT_EQ(device->state(), NmtState::pre_operational) << mode;
    }
}

TEST_F(Ax188001Startup, StoredStartMode5555hAppliesDespiteAnUnsavedWrite) {
    verifies<req::TCS_START_002, req::TCS_START_003, req::TCS_START_006, req::TCS_START_008>();
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    EXPECT_EQ(write(0x5556, 0, 2, 0), 0U);
    for (const int group : {1, 4}) {
        EXPECT_EQ(write(0x5555, 0, 1, 2), 0U);
        EXPECT_EQ(write(0x1010, group, 4, save), 0U);
        EXPECT_EQ(write(0x5555, 0, 1, 0), 0U);
        EXPECT_EQ(send("000#827F"), (Frames{"77F#00", "000#0100"})) << group;
        EXPECT_EQ(device->state(), NmtState::operational) << group;
        EXPECT_EQ(write(0x5555, 0, 1, 1), 0U);
        EXPECT_EQ(write(0x1010, group, 4, save), 0U);
        EXPECT_EQ(write(0x5555, 0, 1, 0), 0U);
        EXPECT_EQ(send("000#827F"), (Frames{"77F#00"})) << group;
        EXPECT_EQ(device->state(), NmtState::operational) << group;
        EXPECT_EQ(write(0x1010, group, 4, save), 0U);
        send("000#827F");
        EXPECT_EQ(device->state(), NmtState::pre_operational) << group;
    }
}

TEST_F(Ax188001Startup, StartMode2StartsTheOtherNodesAfterTheDelay) {
    verifies<req::TCS_START_003, req::TCS_START_006, req::TCS_T3, req::TCS_OD_5556>();
    EXPECT_EQ(read(0x5556).value, 1000U);
    EXPECT_EQ(write(0x5556, 0, 2, 1500), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_EQ(pass(60000), (Frames{"1500:000#0100"}));
}

TEST_F(Ax188001Startup, StartOfTheOtherNodesIsDelayedByUpTo65Seconds) {
    verifies<req::TCS_START_006, req::TCS_OD_5556>();
    EXPECT_EQ(write(0x5556, 0, 2, 65000), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    power_on();
    EXPECT_EQ(pass(70000), (Frames{"65000:000#0100"}));
}

TEST_F(Ax188001Startup, NmtCommandCancelsTheStartOfTheOtherNodes) {
    verifies<req::TCS_START_007>();
    start_with(2);
    power_on();
    pass(500);
    send("000#807F");
    EXPECT_EQ(pass(5000), Frames{});
    power_on();
    pass(500);
    send("000#0200");
    EXPECT_EQ(pass(5000), Frames{});
    power_on();
    pass(500);
    send("000#0205");  // a command for another node also shows that a master is present
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_EQ(pass(5000), (Frames{"500:1FF#A012A012", "1500:1FF#A012A012", "2500:1FF#A012A012", "3500:1FF#A012A012",
                                  "4500:1FF#A012A012"}));
    for (const char* other : {"000#FF00", "201#0205"}) {  // 000#FF00 is no NMT command; 201#0205 looks like a stop
                                                          // command, but its identifier is not 000h
        power_on();
        pass(500);
        send(other);
        const Frames frames = pass(600);
        EXPECT_NE(std::find(frames.begin(), frames.end(), "500:000#0100"), frames.end()) << other;
    }
}

/// A reset also cancels the start command that the previous boot-up has planned. The new boot-up plans its own, for
/// 1000 ms later.
TEST_F(Ax188001Startup, ResetBeginsTheDelayOfTheStartCommandToOtherNodesAgain) {
    verifies<req::TCS_START_006, req::TCS_START_007>();
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    for (const char* reset : {"000#817F", "000#827F", "000#8100"}) {
        power_on();
        pass(500);
        EXPECT_EQ(send(reset), (Frames{"77F#00"}));
        EXPECT_EQ(pass(5000), (Frames{"1000:000#0100"})) << reset;
        EXPECT_EQ(send(reset), (Frames{"77F#00"}));
        pass(500);
        send("000#0205");  // this command of the master cancels the planned one of the device
        EXPECT_EQ(pass(5000), Frames{}) << reset;
    }
}

TEST_F(Ax188001Startup, FaultPreventsTheSelfStartAndTheStartCommandToOtherNodes) {
    verifies<req::TCS_START_005, req::TCS_START_009>();
    write(0x5051, 1, 2, 0);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    inputs.cpu_temperature = 120.0F;
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#0042010110000000"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);  // 1029h:3 (error behaviour) is 0: pre-operational
    EXPECT_EQ(pass(5000), Frames{});
    EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(pass(5000), Frames{});
    EXPECT_EQ(write(0x1029, 3, 1, 1), 0U);
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    send("000#827F");
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_EQ(pass(5000), (Frames{"1000:000#0100"}));
}

/// The fault begins in the delay of 5556h (Start in Operational NMT Delay), 1000 ms by default.
TEST_F(Ax188001Startup, FaultDuringTheNmtDelay5556hPreventsTheStartCommandToOtherNodes) {
    verifies<req::TCS_START_009>();
    EXPECT_EQ(write(0x5051, 1, 2, 0), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    for (const auto& [reaction, state] :
         {std::pair{0U, NmtState::pre_operational}, {1U, NmtState::operational}, {2U, NmtState::stopped}}) {
        EXPECT_EQ(write(0x1029, 3, 1, reaction), 0U);
        start_with(2);
        EXPECT_EQ(power_on(), (Frames{"77F#00"}));
        pass(500);
        EXPECT_EQ(device->state(), NmtState::operational);
        inputs.cpu_temperature = 120.0F;
        set_inputs();
        const Frames frames = pass(5000);  // the temperature is read at 660 ms
        const Frames told{"160:0FF#0042010110000000"};
        EXPECT_EQ(frames, reaction == 1U ? (Frames{told[0], "500:000#0100"}) : told) << "1029h:3 = " << reaction;
        EXPECT_EQ(device->state(), state);
        inputs.cpu_temperature = 25.0F;
        set_inputs();
        send("000#807F");
    }
}

TEST_F(Ax188001Startup, ChannelFaultPreventsTheSelfStart) {
    verifies<req::TCS_START_005>();
    for (const int channel : {1, 2}) {
        write(0x4030, channel, 2, 0);
    }
    EXPECT_EQ(write(0x1029, 2, 1, 0), 0U);
    start_with(1);
    for (const int channel : {1, 2}) {
        inputs = {};
        heat(channel, 130.0);
        EXPECT_EQ(power_on(), (Frames{"77F#00", channel == 1 ? "0FF#11F0010110000000" : "0FF#11F0010210000000"}));
        EXPECT_EQ(device->state(), NmtState::pre_operational);
        EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
        EXPECT_EQ(device->state(), NmtState::pre_operational);
    }
}

TEST_F(Ax188001Startup, EachSupplyOrTemperatureFaultPreventsTheSelfStartInMode1) {
    verifies<req::TCS_START_005>();
    write(0x5051, 1, 2, 0);
    write(0x5051, 2, 2, 0);
    start_with(1);
    for (const auto& [cpu, supply] : {std::pair{120.0F, 24.0F}, {40.0F, 60.0F}, {40.0F, 8.0F}}) {
        inputs = {};
        inputs.cpu_temperature = cpu;
        inputs.supply = supply;
        power_on();
        EXPECT_EQ(device->state(), NmtState::pre_operational) << cpu << ' ' << supply;
        EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
        EXPECT_EQ(device->state(), NmtState::pre_operational) << cpu << ' ' << supply;
    }
}

TEST_F(Ax188001Startup, FaultAtBootUpIsReportedBeforeItStopsTheNode) {
    verifies<req::TCS_START_005, req::TCS_ERR_010>();
    write(0x5051, 1, 2, 0);
    EXPECT_EQ(write(0x1029, 3, 1, 2), 0U);  // in stopped, the node could not send the emergency message any more
    start_with(1);
    inputs.cpu_temperature = 120.0F;
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#0042010110000000"}));
    EXPECT_EQ(device->state(), NmtState::stopped);
}

TEST_F(Ax188001Startup, ResetByLssRestartsTheDelayOfTheStartCommand) {
    verifies<req::TCS_START_006, req::CO_LSS_018>();
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    for (const std::uint32_t mode : {2U, 1U, 0U}) {
        start_with(2);
        EXPECT_EQ(power_on(), (Frames{"77F#00"}));
        start_with(mode);
        pass(500);
        send("7E5#0401");
        EXPECT_EQ(send("7E5#0400"), (Frames{"77F#00"}));
        EXPECT_EQ(pass(5000), mode == 2 ? (Frames{"1000:000#0100"}) : Frames{}) << mode;
    }
}

TEST_F(Ax188001Startup, DelayOfTheStartCommandIsConfigurable) {
    verifies<req::TCS_START_004, req::TCS_START_008, req::TCS_OD_5556>();
    EXPECT_EQ(write(0x5556, 0, 2, 65001), too_high);
    EXPECT_EQ(write(0x5556, 0, 2, 65000), 0U);
    EXPECT_EQ(write(0x5556, 0, 2, 0), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    const Frames frames = power_on();
    EXPECT_EQ(frames, (Frames{"77F#00", "000#0100"}));
}

TEST_F(Ax188001LssSession, DeviceShipsAsNode127At125kbit) {
    verifies<req::TCS_LSS_001, req::TCS_K_NODE_ID, req::TCS_K_BIT_RATE>();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(device->node_id(), 127);
}

TEST_F(Ax188001LssSession, RestoringDefaultsKeepsTheNodeIdAndBitRateSetByLss) {
    verifies<req::TCS_LSS_006>();
    talk({{"7E5#0401", {}},
          {"7E5#1150", {"7E4#110000"}},
          {"7E5#130003", {"7E4#130000"}},  // 250 kbit/s
          {"7E5#17", {"7E4#170000"}},
          {"7E5#0400", {"750#00"}}});
    node = 80;
    power_on();
    write(0x4030, 1, 2, 1);
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    EXPECT_EQ(write(0x1011, 1, 4, 0x64616F6C), 0U);  // load: all parameters
    for (const char* reset : {"000#8250", "000#8150"}) {
        EXPECT_EQ(send(reset), (Frames{"750#00"}));
    }
    EXPECT_EQ(power_on(), (Frames{"750#00"}));
    EXPECT_EQ(read(0x4030, 1).value, 5000U);  // the defaults are restored
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(Ax188001LssSession, LssSessionOfSection3_1_1_1SetsTheNodeId) {
    verifies<req::TCS_LSS_002, req::TCS_LSS_005>();
    talk({{"7E5#0401", {}}, {"7E5#1150", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"750#00"}}});
    node = 80;
    EXPECT_EQ(read(0x1800, 1).value, 0x40000180U + 80U);
    EXPECT_EQ(read(0x1801, 1).value, 0xC0000280U + 80U);
    EXPECT_EQ(read(0x1403, 1).value, 0xC0000500U + 80U);
    EXPECT_EQ(power_on(), (Frames{"750#00"}));
    write(0x4030, 1, 2, 0);
    heat(1, 130.0);
    EXPECT_EQ(read_once(), (Frames{"165:0D0#11F0010110000000"}));
}

TEST_F(Ax188001LssSession, StoredCobIdsFollowTheNodeIdUnlessTheUserHasChangedThem) {
    verifies<req::TCS_LSS_005, req::TCS_LSS_007>();
    EXPECT_EQ(write(0x1801, 1, 4, 0xC0000333), 0U);
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    talk({{"7E5#0401", {}}, {"7E5#1120", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"720#00"}}});
    node = 0x20;
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(read(0x1800, 1).value, 0x400001A0U);
        EXPECT_EQ(read(0x1801, 1).value, 0xC0000333U);
        EXPECT_EQ(read(0x1402, 1).value, 0xC0000420U);
        power_on();
    }
}

TEST_F(Ax188001LssSession, CapturedSessionChangesTheBitRate) {
    verifies<req::TCS_LSS_003, req::TCS_LSS_004, req::TCS_T4>();
    // Frames 95 to 102 of the capture in the manual. The capture begins when the node already has node-ID 80, so the
    // test first sets it.
    talk({{"7E5#0401", {}}, {"7E5#1150", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"750#00"}}});
    node = 80;
    talk({{"7E5#0401", {}}, {"7E5#130003", {"7E4#130000"}}, {"7E5#158813", {}}});  // a switch delay of 1388h = 5000 ms
    pass(4999);
    EXPECT_EQ(device->bit_rate(), 125000U);
    pass(1);
    EXPECT_EQ(device->bit_rate(), 250000U);
    EXPECT_EQ(send("7E5#17"), Frames{});  // no answer during the second delay
    pass(5000);
    talk({{"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"750#00"}}});
    power_on();
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(Ax188001LssSession, NothingIsSentDuringTheTwoDelaysOfABitRateChange) {
    verifies<req::TCS_LSS_009>();
    EXPECT_EQ(write(0x1017, 0, 2, 100), 0U);  // a heartbeat each 100 ms
    talk({{"7E5#0401", {}}, {"7E5#130003", {"7E4#130000"}}});
    EXPECT_EQ(pass(100), (Frames{"100:77F#7F"}));
    talk({{"7E5#15E803", {}}});  // a switch delay of 3E8h = 1000 ms
    EXPECT_EQ(pass(1999), Frames{});
    EXPECT_EQ(pass(101), (Frames{"1:77F#7F", "101:77F#7F"}));
}

TEST_F(Ax188001LssSession, LssAcceptsTheBitRatesOfTable4) {
    verifies<req::TCS_LSS_003, req::TCS_LSS_008, req::TCS_T4>();
    const std::vector<std::uint32_t> rates{1000000, 800000, 500000, 250000, 125000, 0, 50000, 20000, 10000};
    for (std::size_t index = 0; index < 12; ++index) {
        send("7E5#0401");
        const bool offered = index < rates.size() && rates[index] != 0;
        EXPECT_EQ(send(fmt::format("7E5#1300{:02X}", index)), (Frames{offered ? "7E4#130000" : "7E4#130100"})) << index;
        send("7E5#150100");
        pass(2);
        if (offered) {
            EXPECT_EQ(device->bit_rate(), rates[index]);
        }
        send("7E5#0400");
    }
}

TEST_F(Ax188001LssSession, StoredBitRateAppliesAtTheNextPowerOn) {
    verifies<req::TCS_LSS_004, req::CO_LSS_013, req::CO_LSS_017>();
    talk({{"7E5#0401", {}}, {"7E5#130003", {"7E4#130000"}}, {"7E5#17", {"7E4#170000"}}});  // index 3: 250 kbit/s
    EXPECT_EQ(device->bit_rate(), 125000U);
    send("7E5#0400");
    EXPECT_EQ(device->bit_rate(), 125000U);
    power_on();
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(Ax188001LssSession, DeviceWithoutANodeIdMeasuresButSendsNothing) {
    verifies<req::TCS_LSS_002>();
    talk({{"7E5#0401", {}}, {"7E5#11FF", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}});
    write(0x4030, 1, 2, 0);
    EXPECT_EQ(power_on(), Frames{});
    heat(1, 130.0);
    EXPECT_EQ(pass(20000), Frames{});
    talk({{"7E5#0401", {}}, {"7E5#1105", {"7E4#110000"}}});
    // The fault that is active is reported when the node gets its node-ID.
    EXPECT_EQ(send("7E5#0400"), (Frames{"705#00", "085#11F0010110000000"}));
}

TEST_F(Ax188001LssSession, FaultThatEndedBeforeTheNodeHasANodeIdIsNotReported) {
    verifies<req::TCS_LSS_002, req::TCS_ERR_002>();
    talk({{"7E5#0401", {}}, {"7E5#11FF", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}});
    EXPECT_EQ(power_on(), Frames{});
    heat(1, 130.0);
    EXPECT_EQ(pass(6000), Frames{});
    heat(1, 20.0);
    EXPECT_EQ(pass(1000), Frames{});
    talk({{"7E5#0401", {}}, {"7E5#1105", {"7E4#110000"}}, {"7E5#0400", {"705#00"}}});
}

}  // namespace canproof::test
