// SPDX-License-Identifier: Apache-2.0
// Tests a node where several of its services act together: resets, overdue deadlines, and LSS switch delays.
#include "firmware/canopen/node.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "tests/conformance/lss_cases.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class NodeService : public Lss {
  protected:
    NmtState state() const { return device->node().state(); }
    /// Starts the node, which monitors node 10h. Sends one heartbeat of node 10h, and then none for 100 ms.
    void lose_producer() {
        EXPECT_EQ(send("605#2316100164001000"), Frames{"585#6016100100000000"});
        send("000#0105");
        send("710#05");
        EXPECT_EQ(state(), NmtState::operational);
        EXPECT_EQ(pass(100), Frames{"100:085#3081110100000000"});
    }
};

/// A device that resets its communication at each switch from LSS configuration to LSS waiting.
class SelfResetting : public NodeService {
  protected:
    SelfResetting() {
        resets_itself = true;
        start({5, 125000});
    }
};

class SlaveNode : public testing::Test, public SlaveBench {};

class AlteredNode : public testing::Test, public AlteredSlaveBench {};

}  // namespace

TEST_F(NodeService, HeartbeatErrorLeadsToPreOperationalAlsoAfterResetNode) {
    verifies<req::CO_NMT_007, req::CO_HB_004>();
    for (int round = 1; round <= 3; ++round) {
        lose_producer();
        EXPECT_EQ(state(), NmtState::pre_operational) << round;
        EXPECT_EQ(device->communication_errors(), round);
        EXPECT_EQ(send("000#8105"), Frames{"705#00"});
    }
}

TEST_F(NodeService, EachCommunicationErrorActsAsErrorBehaviour1029hRequiresEvenWhileAnotherLasts) {
    verifies<req::CO_NMT_007>();
    send("605#2316100264001100");  // 1016h:2 consumer heartbeat time: node 11h, 100 ms
    send("605#2B0C100032000000");  // 100Ch guard time: 50 ms
    send("605#2F0D100002000000");  // 100Dh life time factor: 2
    send("605#2B00140564000000");  // 1400h:5 event timer of RPDO1: 100 ms
    send("605#2B01140564000000");  // 1401h:5 event timer of RPDO2: 100 ms
    lose_producer();               // node 10h stays silent from now on
    EXPECT_EQ(state(), NmtState::pre_operational);
    for (const char* heard_once : {"711#05", "705#R1", "205#1122", "305#0100020003000400"}) {
        send("000#0105");  // the master starts the node although the error of node 10h lasts
        send(heard_once);
        pass(99);
        EXPECT_EQ(state(), NmtState::operational) << heard_once;
        pass(1);
        EXPECT_EQ(state(), NmtState::pre_operational) << heard_once;
    }
    send("000#0105");
    device->node().set_can_state(CanState::bus_off, now);
    EXPECT_EQ(state(), NmtState::pre_operational);
    device->node().set_can_state(CanState::error_active, now);
    // The device was notified only once, because node 10h stays silent: a communication error has been active all the
    // time.
    EXPECT_EQ(device->communication_errors(), 1);
    send("605#2F29100102000000");  // 1029h:1 error behaviour: stopped
    send("000#0105");
    send("711#05");
    pass(100);
    EXPECT_EQ(state(), NmtState::stopped);
}

TEST_F(NodeService, LastingCommunicationErrorChangesTheNmtStateOnce) {
    verifies<req::CO_NMT_007>();
    lose_producer();
    send("000#0105");
    pass(1000);
    EXPECT_EQ(state(), NmtState::operational);
    send("205#11");  // too short for RPDO1: error 8210h is no communication error of 1029h:1
    EXPECT_EQ(state(), NmtState::operational);
}

TEST_F(NodeService, BusOffAtPowerOnLeadsToStoppedIfErrorBehaviour1029hSelectsStopped) {
    verifies<req::CO_NMT_007>();
    send("605#2F29100102000000");  // 1029h:1 error behaviour: stopped
    EXPECT_EQ(send("605#2310100173617665"), Frames{"585#6010100100000000"});
    can_state = 3;
    EXPECT_EQ(power_on(), Frames{});
    EXPECT_EQ(state(), NmtState::stopped);
    EXPECT_EQ(device->communication_errors(), 1);
}

TEST_F(NodeService, SelfStartHappensAtItsPlannedTime) {
    verifies<req::CO_NMT_008>();
    device->advance(now);
    device->node().start_at(now + milliseconds(100));
    EXPECT_EQ(device->next_deadline().us, (now + milliseconds(100)).us);
    pass(99);
    EXPECT_EQ(state(), NmtState::pre_operational);
    pass(1);
    EXPECT_EQ(state(), NmtState::operational);
}

TEST_F(SelfResetting, ResetByLssCancelsAPlannedSelfStart) {
    verifies<req::CO_NMT_008, req::CO_NMT_006>();
    device->node().start_at(now + milliseconds(100));
    configure();
    EXPECT_EQ(send("7E5#0400000000000000"), Frames{"705#00"});
    pass(200);
    EXPECT_EQ(state(), NmtState::pre_operational);
}

/// The device was not called when the SDO time-out ended. It must handle the time-out before the frame that comes next.
TEST_F(NodeService, SdoTimeOutThatIsDueIsHandledBeforeTheNextFrame) {
    verifies<req::CO_SDO_014>();
    send("605#4008100000000000");
    now = now + milliseconds(1000);
    EXPECT_EQ(send("605#6000000000000000"), (Frames{"585#8008100000000405", "585#8000000001000405"}));
}

TEST_F(NodeService, LssSwitchDelayEndsAnSdoTransfer) {
    verifies<req::CO_LSS_019>();
    configure();
    send("605#4008100000000000");
    talk({{"7E5#150A000000000000", {}}});
    EXPECT_EQ(pass(20), Frames{});
    EXPECT_EQ(send("605#6000000000000000"), Frames{"585#8000000001000405"});
}

TEST_F(NodeService, NoEmcyIsSentAfterAnLssSwitchDelayWithoutANodeId) {
    verifies<req::CO_LSS_030>();
    send("000#0105");
    configure();
    send("000#8005");
    talk({{"7E5#11FF000000000000", {"7E4#1100000000000000"}}, {"000#8205", {}}});
    device->node().set_overrun(true, now);
    configure();
    talk({{"7E5#150A000000000000", {}}});
    EXPECT_EQ(pass(100), Frames{});
    EXPECT_EQ(sent(), Frames{});
}

TEST_F(NodeService, NoTpdoIsSentWithoutANodeId) {
    verifies<req::CO_LSS_030, req::CO_PDO_018>();
    configure();
    talk({{"7E5#11FF000000000000", {"7E4#1100000000000000"}}, {"7E5#0400000000000000", {}}});
    EXPECT_EQ(send("000#0105"), Frames{"185#0000"});
    device->node().process_value_changed(0x2001, 1, now);
    EXPECT_EQ(pass(1), Frames{"0:185#0000"});
    EXPECT_EQ(send("000#8205"), Frames{});
    device->node().process_value_changed(0x2001, 1, now);
    EXPECT_EQ(pass(1000), Frames{});
}

TEST_F(NodeService, HeartbeatProducerThatFailsASecondTimeIsReportedAgain) {
    verifies<req::CO_HB_004>();
    send("605#2F29100101000000");  // 1029h:1 error behaviour: no change of state
    lose_producer();
    EXPECT_EQ(send("710#05"), Frames{"085#0000000100000000"});
    EXPECT_EQ(pass(99), Frames{});
    EXPECT_EQ(pass(1), Frames{"1:085#3081110200000000"});
}

TEST_F(NodeService, WriteToOneConsumerHeartbeatEntryKeepsTheOtherProducersMonitored) {
    verifies<req::CO_HB_002, req::CO_HB_004, req::CO_HB_003>();
    send("605#2316100164001000");  // 1016h:1 consumer heartbeat time: node 10h, 100 ms
    send("605#2316100264001100");  // 1016h:2 consumer heartbeat time: node 11h, 100 ms
    for (const char* entry : {"605#2316100164001000", "605#2316100100000000"}) {
        send("710#05");
        send("711#05");
        send(entry);
        EXPECT_EQ(pass(99), Frames{});
        EXPECT_EQ(pass(1).size(), 1U) << entry;  // the heartbeat of node 11h is missing
        EXPECT_EQ(send("711#05").size(), 1U) << entry;
        send("605#2316100200000000");
        send("605#2316100264001100");
    }
}

TEST_F(NodeService, HeartbeatProducerNoLongerMonitoredHasNoDeadline) {
    verifies<req::CO_HB_003>();
    EXPECT_EQ(device->next_deadline().us, never.us);
    send("605#2316100164001000");
    send("710#05");
    EXPECT_EQ(device->next_deadline().us, (now + milliseconds(100)).us);
    send("605#2316100164000000");
    EXPECT_EQ(device->next_deadline().us, never.us);
}

/// The default of 1401h:1 is 300h + node-ID. With each save, the device also stores the node-ID with which the
/// communication parameters were saved.
TEST_F(SlaveNode, StoredDefaultCobIdsFollowTheNodeIdAfterSavesOfOtherParameterGroups) {
    verifies<req::CO_PDO_035, req::CO_STORE_003>();
    const std::string saved_communication = "585#6010100200000000";
    EXPECT_EQ(send("605#2310100273617665"), Frames{saved_communication});
    node_id = 7;
    power_on();
    for (const int id : {7, 8, 8, 10}) {
        node_id = static_cast<std::uint8_t>(id);
        EXPECT_EQ(power_on().at(0), fmt::format("7{:02X}#00", id));
        const std::string answer = send(fmt::format("6{:02X}#2310100473617665", id)).at(0);
        EXPECT_EQ(answer, fmt::format("5{:02X}#6010100400000000", 0x80 + id));
    }
    node_id = 9;
    EXPECT_EQ(power_on(), Frames{"709#00"});
    EXPECT_EQ(send("609#4001140100000000"), Frames{"589#4301140109030000"});
}

TEST_F(AlteredNode, RefusedSecondValueDiscardsTheWholePdo) {
    verifies<req::CO_PDO_005, req::CO_SYNC_007>();
    ship(0x1600, 1, 0x20000108);
    ship(0x1600, 2, 0x10190008);  // 1019h (SYNC counter overflow), in which 1 is reserved
    power_on();
    send("000#0105");
    send("205#5501");
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200100000000"});
    send("205#0102");
    EXPECT_EQ(send("605#4019100000000000"), Frames{"585#4F19100002000000"});
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200101000000"});
}

TEST_F(AlteredNode, ErrorListOfOneEntryHoldsTheLatestError) {
    verifies<req::CO_EMCY_008, req::CO_EMCY_026>();
    const auto is_list = [](const ObjectRow& row) { return row.index == 0x1003; };
    auto& objects = description.rows.objects;
    std::find_if(objects.begin(), objects.end(), is_list)->count = 2;  // sub-indices 0 and 1
    power_on();
    send("080#01");  // the SYNC has a wrong length: 8240h
    EXPECT_EQ(send("605#4003100100000000"), Frames{"585#4303100140820000"});
    device->node().set_overrun(true, now);  // reports an overrun: error 8110h
    sent();
    EXPECT_EQ(send("605#4003100100000000"), Frames{"585#4303100110810000"});
    EXPECT_EQ(send("605#4003100000000000"), Frames{"585#4F03100001000000"});
}

}  // namespace canproof::test
