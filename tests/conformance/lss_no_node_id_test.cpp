// SPDX-License-Identifier: Apache-2.0
// Tests LSS of a node without a node-ID (CiA 305, 6.4.2): which LSS services it has, and how it gets a node-ID.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/lss_cases.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// The slave without RPDOs: their communication parameters have indices that a node does not serve, from 1408h on.
class WithoutRpdos : public testing::Test, public AlteredSlaveBench {};

}  // namespace

TEST_F(Unconfigured, ControllerErrorsBeforeTheNodeHasANodeIdAreNotReported) {
    verifies<req::CO_LSS_030, req::CO_LSS_031>();
    device->node().set_can_state(CanState::bus_off, now);
    device->node().set_can_state(CanState::error_active, now);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(device->communication_errors(), 0);
    talk({{"7E5#0401", {}}, {"7E5#1105", {"7E4#110000"}}, {"7E5#0400", {"705#00"}}});
    EXPECT_EQ(pass(100), Frames{});
}

TEST_F(Unconfigured, ErrorPassiveAtBootUpIsReported) {
    verifies<req::CO_LSS_031, req::CO_EMCY_001>();
    device->node().set_can_state(CanState::error_passive, now);
    EXPECT_EQ(sent(), Frames{});
    talk({{"7E5#0401", {}},
          {"7E5#1105", {"7E4#110000"}},
          {"7E5#0400", {"705#00", "085#2081110100000000"}},  // error 8120h is reported after the boot-up
          {"605#4001100000000000", {"585#4F01100011000000"}}});
    device->node().set_can_state(CanState::error_active, now);
    EXPECT_EQ(sent(), (Frames{"085#0000000100000000"}));
}

TEST_F(Unconfigured, OnlyLssIsServedWithoutANodeId) {
    verifies<req::CO_LSS_030, req::CO_K_LSS_UNCONFIGURED>();
    EXPECT_EQ(first_frames, Frames{});
    EXPECT_EQ(pass(5000), Frames{});
    talk({{"000#0100", {}},
          {"000#8100", {}},
          {"000#8200", {}},
          {"000#01FF", {}},
          {"605#4000100000000000", {}},
          {"6FF#4000100000000000", {}},
          {"7FF#R", {}},
          {"700#R", {}},
          {"080#", {}}});
    EXPECT_EQ(state(), NmtState::initialising);
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent(), Frames{});
    talk({{"7E5#4C00000000000000", {"7E4#5000000000000000"}}});
    EXPECT_EQ(device->next_deadline(), never);
}

TEST_F(Unconfigured, NewNodeIdTakesEffectAtTheSwitchToLssWaiting) {
    verifies<req::CO_LSS_031, req::CO_LSS_041>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5EFF000000000000"}},
          {"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#5E00000000000000", {"7E4#5EFF000000000000"}},  // the active node-ID is still FFh, while 20h is pending
          {"620#4000100000000000", {}},
          {"7E5#0400000000000000", {"720#00"}},
          {"620#4000100000000000", {"5A0#4300100078563412"}},
          {"000#0120", {"1A0#0000"}}});
    EXPECT_EQ(state(), NmtState::operational);
}

TEST_F(Unconfigured, LeavingLssConfigurationWithoutANodeIdChangesNothing) {
    verifies<req::CO_LSS_030, req::CO_LSS_031>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#1120000000000000", {"7E4#1100000000000000"}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},  // the node-ID is removed again
          {"7E5#0400000000000000", {}}});
    EXPECT_EQ(pass(5000), Frames{});
    EXPECT_EQ(state(), NmtState::initialising);
}

TEST_F(Unconfigured, SelfResettingDeviceSendsNothingWithoutANodeId) {
    verifies<req::CO_LSS_018, req::CO_LSS_030>();
    resets_itself = true;
    start({255, 125000});
    talk({{"7E5#0401", {}}, {"7E5#0400", {}}, {"7E5#4C", {"7E4#50"}}});
    talk({{"7E5#0401", {}}, {"7E5#1107", {"7E4#110000"}}, {"7E5#0400", {"707#00"}}});
}

TEST_F(Lss, NodeIdCanBeRemovedByLss) {
    verifies<req::CO_LSS_010, req::CO_LSS_030>();
    talk({{"605#2B1710000A000000", {"585#6017100000000000"}},  // heartbeat every 10 ms
          {"7E5#0401000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {}}});
    EXPECT_EQ(pass(10), (Frames{"10:705#7F"}));
    talk({{"000#8205", {}}});
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(state(), NmtState::initialising);
    EXPECT_EQ(send("605#4000100000000000"), Frames{}) << "no SDO at the identifier of node 5";
    talk({{"7E5#4C00000000000000", {"7E4#5000000000000000"}},
          {"7E5#0401000000000000", {}},
          {"7E5#1106000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {"706#00"}}});
}

TEST_F(WithoutRpdos, CommunicationErrorEndsWhenAResetRemovesTheNodeId) {
    verifies<req::CO_NMT_006, req::CO_LSS_030>();
    for (std::uint16_t number = 4; number > 0; --number) {
        renumber(static_cast<std::uint16_t>(0x13FF + number), static_cast<std::uint16_t>(0x1407 + number));
    }
    power_on();
    talk(*this, {{"605#2316100114000A00", {"585#6016100100000000"}},  // 1016h:1: node 10, a heartbeat every 20 ms
                 {"70A#05", {}}});
    pass(20);
    EXPECT_EQ(device->communication_errors(), 1) << "the heartbeat is missing";
    talk(*this, {{"7E5#0401000000000000", {}}, {"7E5#11FF000000000000", {"7E4#1100000000000000"}}, {"000#8205", {}}});
    EXPECT_EQ(device->communication_errors(), 2) << "without a node-ID the node expects no heartbeat";
}

TEST_F(Unconfigured, TheBitRateCanBeChangedWithoutANodeId) {
    verifies<req::CO_LSS_030, req::CO_LSS_014>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#1300000000000000", {"7E4#1300000000000000"}},
          {"7E5#1505000000000000", {}}});
    EXPECT_EQ(pass(5), Frames{});
    EXPECT_EQ(bit_rate(), 1000000U);
    talk({{"7E5#5E00000000000000", {}}});
    pass(5);
    talk({{"7E5#5E00000000000000", {"7E4#5EFF000000000000"}}});
}

}  // namespace canproof::test
