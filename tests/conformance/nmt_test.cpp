// SPDX-License-Identifier: Apache-2.0
// Tests NMT of a slave (CiA 301, 7.2.8 and 7.3.2) on a CAN-CBX-AO412 as node 3.
#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Nmt : public CbxTest {
  protected:
    /// Reads the NMT state by node guarding (CiA 301, 7.2.8.2.2), without the toggle bit.
    std::string state() {
        const std::string answer = send("703#R").at(0);
        const unsigned octet = static_cast<unsigned>(std::stoul(answer.substr(4), nullptr, 16)) & 0x7FU;
        return octet == 0x7FU ? "pre-operational" : octet == 5U ? "operational" : octet == 4U ? "stopped" : "?";
    }
};

}  // namespace

TEST_F(Nmt, PowerOnSendsOneBootUpMessageAndEntersPreOperational) {
    verifies<req::CO_NMT_001, req::CO_E_NMT_STATE, req::CO_K_GUARDING_ID, req::CO_NMT_012>();
    EXPECT_EQ(power_on(), (Frames{"703#00"}));
    EXPECT_EQ(state(), "pre-operational");
}

TEST_F(Nmt, ResetsSendTheBootUpMessage) {
    verifies<req::CO_NMT_001, req::CO_E_NMT_COMMAND, req::CO_NMT_012>();
    send("000#0103");
    EXPECT_EQ(send("000#8103"), (Frames{"703#00"}));
    EXPECT_EQ(state(), "pre-operational");
    send("000#0103");
    EXPECT_EQ(send("000#8203"), (Frames{"703#00"}));
    EXPECT_EQ(state(), "pre-operational");
}

TEST_F(Nmt, CommandsReachEachStateFromEachOtherState) {
    verifies<req::CO_NMT_002, req::CO_E_NMT_COMMAND, req::CO_E_NMT_STATE>();
    const std::vector<std::pair<std::string, std::string>> commands{
        {"000#0103", "operational"}, {"000#0203", "stopped"}, {"000#8003", "pre-operational"}};
    for (const auto& [from, from_state] : commands) {
        for (const auto& [to, to_state] : commands) {
            send(from);
            ASSERT_EQ(state(), from_state);
            send(to);
            EXPECT_EQ(state(), to_state) << from << " then " << to;
        }
    }
}

TEST_F(Nmt, NodeObeysACommandToAllAndIgnoresOneToAnotherNode) {
    verifies<req::CO_NMT_003, req::CO_NMT_009, req::CO_K_NMT_ID>();
    send("000#0104");
    EXPECT_EQ(state(), "pre-operational");
    send("000#0100");
    EXPECT_EQ(state(), "operational");
}

TEST_F(Nmt, UnknownNmtCommandsWrongLengthsAndRemoteFramesAreIgnored) {
    verifies<req::CO_NMT_004>();
    for (const char* frame : {"000#01", "000#010300", "000#", "000#R2", "000#0303", "000#7F03", "000#0003"}) {
        EXPECT_TRUE(send(frame).empty()) << frame;
        EXPECT_EQ(state(), "pre-operational") << frame;
    }
}

TEST_F(Nmt, CommandDuringBusOffIsIgnored) {
    shows_rule("a controller that is bus-off receives nothing");
    inputs.can_state = 3;
    set_inputs();
    send("000#0203");
    inputs.can_state = 0;
    set_inputs();
    EXPECT_EQ(state(), "pre-operational");
}

TEST_F(Nmt, ResetCommunicationRestoresTheHeartbeatTimeAndResetNodeAlsoTheOutputValues) {
    verifies<req::CO_NMT_005, req::CO_NMT_006>();
    write("603#2B171000E8030000");  // 1017h producer heartbeat time: 1000 ms
    write("603#2B116401B33E0000");  // writes 3EB3h to 6411h:1
    send("000#8203");
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));
    EXPECT_EQ(send("603#4011640100000000"), (Frames{"583#4B116401B33E0000"}));
    send("000#8103");
    EXPECT_EQ(send("603#4011640100000000"), (Frames{"583#4B11640100000000"}));
}

TEST_F(Nmt, TwentyNineBitFramesAreIgnored) {
    verifies<req::CO_FRAME_001>();
    EXPECT_TRUE(send("00000000#0103").empty());
    EXPECT_TRUE(send("00000603#4000100000000000").empty());
    EXPECT_TRUE(send("00000703#R").empty());
    EXPECT_EQ(state(), "pre-operational");
}

// Tests the fields of table CO-T-SERVICES by observing which services of the node work (CiA 301, 7.3.2.3).
TEST_F(Nmt, SdoSyncEmcyAndRpdoWorkInTheirNmtStatesOnly) {
    verifies<req::CO_T_SERVICES, req::CO_E_NMT_STATE, req::CO_SDO_017, req::CO_SDO_045>();
    write("603#2305100080000040");  // 1005h COB-ID SYNC: the node produces SYNC
    write("603#2306100010270000");  // 1006h communication cycle period: 10 ms
    // pre-operational: SDO, SYNC, EMCY, error control; no PDO. Bit 7, the toggle bit, is set in every
    // second answer.
    EXPECT_EQ(send("703#R"), (Frames{"703#7F"}));
    EXPECT_EQ(pass(10), (Frames{"10:080#"}));
    EXPECT_EQ(send("603#4001100000000000"), (Frames{"583#4F01100000000000"}));
    send("303#0100000000000000");
    EXPECT_EQ(send("603#4011640100000000"), (Frames{"583#4B11640100000000"}));
    inputs.can_overrun = true;
    EXPECT_EQ(set_inputs(), (Frames{"083#1081110100000000"}));
    // operational: all services work
    send("000#0103");
    EXPECT_EQ(send("703#R"), (Frames{"703#85"}));
    send("303#0100000000000000");
    EXPECT_EQ(send("603#4011640100000000"), (Frames{"583#4B11640101000000"}));
    EXPECT_EQ(pass(10), (Frames{"10:080#"}));
    inputs.can_overrun = false;
    EXPECT_EQ(set_inputs(), (Frames{"083#0000000100000000"}));
    // stopped: only error control works
    send("000#0203");
    EXPECT_EQ(send("703#R"), (Frames{"703#04"}));
    EXPECT_TRUE(pass(100).empty());
    EXPECT_TRUE(send("603#4001100000000000").empty());
    send("303#0200000000000000");
    inputs.can_overrun = true;
    EXPECT_TRUE(set_inputs().empty());
    send("000#8003");
    EXPECT_EQ(send("603#4011640100000000"), (Frames{"583#4B11640101000000"}));
}

}  // namespace canproof::test
