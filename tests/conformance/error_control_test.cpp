// SPDX-License-Identifier: Apache-2.0
// Heartbeat, node guarding and life guarding (CiA 301, 7.2.8.2; CAN-CBX-AO412, 7.9.10, 7.9.11, 7.9.16, 7.9.17, 7.9.21),
// node 3.
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

using ErrorControlService = CbxTest;

/// Node 5, whose 1016h (consumer heartbeat time) has four entries without limits.
class SlaveErrorControl : public testing::Test, public SlaveBench {};

TEST_F(ErrorControlService, HeartbeatCarriesTheNmtStateEachPeriod) {
    verifies<req::CO_HB_001, req::CO_HB_005>();
    write("603#2B17100064000000");  // 1017h producer heartbeat time: 100 ms
    EXPECT_EQ(pass(250), (Frames{"100:703#7F", "200:703#7F"}));
    send("000#0103");
    EXPECT_EQ(pass(100), (Frames{"50:703#05"}));
    send("000#0203");
    EXPECT_EQ(pass(100), (Frames{"50:703#04"}));
    send("000#8003");
    write("603#2B17100000000000");
    EXPECT_TRUE(pass(500).empty());
}

TEST_F(ErrorControlService, HeartbeatWithAStoredPeriodRunsFromBootUp) {
    verifies<req::CO_HB_001, req::CO_HB_005>();
    write("603#2B17100064000000");
    write("603#2310100173617665");
    EXPECT_EQ(power_on(), (Frames{"703#00"}));
    EXPECT_EQ(pass(100), (Frames{"100:703#7F"}));
}

TEST_F(ErrorControlService, SeveralOverdueHeartbeatsAreSentAsOneAndThePeriodRestarts) {
    verifies<req::CO_HB_001>();
    write("603#2B17100064000000");  // heartbeat every 100 ms; those of 100, 200 and 300 ms are due at the next call
    now = now + milliseconds(350);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"703#7F"}));
    EXPECT_TRUE(pass(99).empty());
    EXPECT_EQ(pass(1), (Frames{"1:703#7F"}));
}

TEST_F(ErrorControlService, ExtendedFrameIsNoHeartbeat) {
    verifies<req::CO_HB_002>();
    write("603#23161001C8003100");  // 1016h:1 consumer heartbeat time: node 31h, 200 ms
    send("00000731#05");
    EXPECT_TRUE(pass(1000).empty());
    send("731#05");
    EXPECT_EQ(pass(200), (Frames{"200:083#3081110100000000"}));
}

TEST_F(ErrorControlService, LifeGuardingContinuesWithANewGuardTimeAndEndsWithGuardTime0) {
    verifies<req::CO_GUARD_007>();
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100003000000");  // 100Dh life time factor: 3
    send("703#R1");
    EXPECT_TRUE(pass(200).empty());
    write("603#2B0C1000C8000000");  // 100Ch guard time: 200 ms from now on
    EXPECT_TRUE(pass(599).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
    send("703#R1");
    write("603#2B0C100000000000");
    EXPECT_TRUE(pass(2000).empty());
}

TEST_F(ErrorControlService, HeartbeatLateByLessThanAPeriodDoesNotDelayTheNextOnes) {
    verifies<req::CO_HB_001>();
    write("603#2B17100064000000");  // 1017h producer heartbeat time: 100 ms
    now = now + milliseconds(130);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"703#7F"}));
    EXPECT_EQ(pass(170), (Frames{"70:703#7F", "170:703#7F"}));  // at 200 and 300 ms
}

TEST_F(ErrorControlService, NewLifeTimeFactorRestartsLifeGuarding) {
    verifies<req::CO_GUARD_007>();
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100003000000");  // 100Dh life time factor: 3
    send("703#R1");
    EXPECT_TRUE(pass(200).empty());
    write("603#2F0D100005000000");  // 100Dh life time factor: 5 from now on
    EXPECT_TRUE(pass(499).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
}

TEST_F(ErrorControlService, UnrelatedWritesDoNotRestartLifeGuarding) {
    verifies<req::CO_GUARD_007, req::CO_GUARD_008>();
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100003000000");  // 100Dh life time factor: 3
    send("703#R1");
    EXPECT_TRUE(pass(200).empty());
    write("603#230E100003070000");  // 100Eh node guarding identifier: 703h again, the value that it has
    write("603#2B17100000000000");  // 1017h producer heartbeat time: still off
    EXPECT_TRUE(pass(99).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
}

TEST_F(ErrorControlService, ConsumerMonitorsFromTheFirstHeartbeatOn) {
    verifies<req::CO_EMCY_016, req::CO_HB_002, req::CO_HB_004, req::AO4_ERR_021>();
    write("603#23161001C8003100");    // 1016h:1 consumer heartbeat time: node 31h, 200 ms
    EXPECT_TRUE(pass(1000).empty());  // no heartbeat received yet, so none is missing
    send("731#05");
    EXPECT_TRUE(pass(199).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
    EXPECT_EQ(send("731#05"), (Frames{"083#0000000100000000"}));
    pass(150);
    send("731#05");
    EXPECT_TRUE(pass(199).empty());
}

TEST_F(ErrorControlService, HeartbeatsOfNodes1And127AreMonitored) {
    verifies<req::CO_HB_002, req::CO_HB_004, req::CO_HB_003>();
    write("603#23161001C8000100");  // 1016h:1 consumer heartbeat time: node 1, 200 ms
    send("701#05");
    EXPECT_EQ(pass(200), (Frames{"200:083#3081110100000000"}));
    send("701#05");
    write("603#23161001C8007F00");  // 1016h:1 consumer heartbeat time: node 127
    send("77F#05");
    EXPECT_EQ(pass(200), (Frames{"200:083#3081110200000000"}));  // 1003h (error list) has two errors now
}

TEST_F(ErrorControlService, HeartbeatOfAnUnmonitoredNodeOrOfWrongLengthIsIgnored) {
    verifies<req::CO_HB_002>();
    write("603#23161001C8003100");
    send("732#05");
    send("731#0505");
    send("731#R1");
    EXPECT_TRUE(pass(1000).empty());
}

TEST_F(ErrorControlService, ConsumerHeartbeatEntryWithoutTimeOrNodeIdMonitorsNoNode) {
    verifies<req::CO_HB_003>();
    for (const char* entry : {"00003100", "C8000000"}) {
        write(std::string{"603#23161001"} + entry);
        send("731#05");
        send("700#05");
        EXPECT_TRUE(pass(1000).empty()) << entry;
    }
}

TEST_F(SlaveErrorControl, ProducerInTwoActiveConsumerHeartbeatEntriesIsRefused) {
    verifies<req::CO_HB_002, req::CO_HB_003>();
    // 1016h:1 consumer heartbeat time: node 31h, 200 ms
    EXPECT_EQ(send("605#23161001C8003100"), (Frames{"585#6016100100000000"}));
    EXPECT_EQ(send("605#2316100164003100"), (Frames{"585#6016100100000000"}));  // accepted: entry 1 again
    EXPECT_EQ(send("605#23161002C8003100"), (Frames{"585#8016100243000406"}));
    EXPECT_EQ(send("605#2316100200003100"), (Frames{"585#6016100200000000"}));  // with a time of 0, it monitors no node
    EXPECT_EQ(send("605#23161001C8003100"), (Frames{"585#6016100100000000"}));
}

TEST_F(SlaveErrorControl, ConsumerHeartbeatEntryWithAnImpossibleNodeIdMonitorsNoNode) {
    verifies<req::CO_HB_003>();
    // 1016h:1 consumer heartbeat time: node 128
    EXPECT_EQ(send("605#23161001C8008000"), (Frames{"585#6016100100000000"}));
    EXPECT_TRUE(send("780#05").empty());
    EXPECT_TRUE(pass(1000).empty());
}

TEST_F(ErrorControlService, ResetCommunicationEndsTheMonitoringOfHeartbeats) {
    verifies<req::CO_HB_002, req::CO_HB_004, req::CO_NMT_006>();
    write("603#23161001C8003100");
    send("731#05");
    EXPECT_EQ(send("000#8203"), (Frames{"703#00"}));
    send("731#05");  // the reset has set 1016h (consumer heartbeat time) to 0, so node 31h is not monitored
    EXPECT_TRUE(pass(1000).empty());
}

TEST_F(ErrorControlService, RewritingAConsumerHeartbeatEntryEndsItsHeartbeatError) {
    verifies<req::CO_HB_004>();
    write("603#23161001C8003100");  // 1016h:1 consumer heartbeat time: node 31h, 200 ms
    send("731#05");
    EXPECT_EQ(pass(200), (Frames{"200:083#3081110100000000"}));
    EXPECT_EQ(send("603#23161001C8003200"), (Frames{"083#0000000100000000", "583#6016100100000000"}));
    send("732#05");
    EXPECT_TRUE(pass(199).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110200000000"}));
}

TEST_F(ErrorControlService, ResetCommunicationEndsTheHeartbeatError) {
    verifies<req::CO_HB_004, req::CO_NMT_006>();
    write("603#23161001C8003100");  // 1016h:1 consumer heartbeat time: node 31h, 200 ms
    send("731#05");
    EXPECT_EQ(pass(200), (Frames{"200:083#3081110100000000"}));
    EXPECT_EQ(send("000#8203"), (Frames{"703#00", "083#0000000000000000"}));  // 1003h (error list) is empty
    EXPECT_TRUE(pass(1000).empty());
}

TEST_F(ErrorControlService, GuardingRequestIsAnsweredWithStateAndToggleBit) {
    verifies<req::CO_GUARD_001, req::CO_GUARD_009>();
    EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
    EXPECT_EQ(send("703#R1"), (Frames{"703#FF"}));
    send("000#0103");
    EXPECT_EQ(send("703#R1"), (Frames{"703#05"}));
    EXPECT_EQ(send("703#R1"), (Frames{"703#85"}));
    send("000#8203");
    EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));  // after the reset the toggle bit begins at 0 again
}

TEST_F(ErrorControlService, LifeGuardingBeginsWithTheFirstGuardingRequest) {
    verifies<req::CO_GUARD_002, req::CO_GUARD_007, req::CO_EMCY_016, req::AO4_ERR_021>();
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100003000000");  // 100Dh life time factor: 3
    EXPECT_TRUE(pass(1000).empty());
    send("703#R1");
    EXPECT_TRUE(pass(299).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
    EXPECT_EQ(send("703#R1"), (Frames{"083#0000000100000000", "703#FF"}));
}

TEST_F(ErrorControlService, ResetEndsAFailedLifeGuardingAndClearsTheToggleBit) {
    verifies<req::CO_GUARD_001, req::CO_GUARD_002, req::CO_NMT_006, req::CO_GUARD_009>();
    for (const bool whole_node : {true, false}) {
        write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
        write("603#2F0D100001000000");  // 100Dh life time factor: 1
        EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
        EXPECT_EQ(pass(100), (Frames{"100:083#3081110100000000"}));
        if (whole_node) {
            EXPECT_EQ(send("000#8103"), (Frames{"703#00"}));
        } else {
            EXPECT_EQ(send("000#8203"), (Frames{"703#00", "083#0000000000000000"}));
        }
        EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
        EXPECT_EQ(send("703#R1"), (Frames{"703#FF"}));
        EXPECT_EQ(send("000#8103"), (Frames{"703#00"}));
    }
}

TEST_F(ErrorControlService, StartingTheHeartbeatEndsAFailedLifeGuarding) {
    verifies<req::CO_GUARD_008>();
    write("603#2B0C100064000000");
    write("603#2F0D100001000000");
    send("703#R1");
    EXPECT_EQ(pass(100), (Frames{"100:083#3081110100000000"}));
    EXPECT_EQ(send("603#2B171000F4010000"), (Frames{"083#0000000100000000", "583#6017100000000000"}));
}

TEST_F(ErrorControlService, GuardTimeOrLifeTimeFactorOf0EndsAFailedLifeGuarding) {
    verifies<req::CO_GUARD_006>();
    for (const std::string off : {"603#2B0C100000000000", "603#2F0D100000000000"}) {
        write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
        write("603#2F0D100001000000");  // 100Dh life time factor: 1
        EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
        EXPECT_EQ(pass(100), (Frames{"100:083#3081110100000000"}));
        EXPECT_EQ(send(off), (Frames{"083#0000000100000000", "583#60" + off.substr(6, 6) + "00000000"}));
        EXPECT_EQ(send("703#R1"), (Frames{"703#FF"}));
        EXPECT_TRUE(pass(1000).empty()) << off;
        EXPECT_EQ(send("000#8103"), (Frames{"703#00"}));  // the reset clears the toggle bit and 1003h (error list)
    }
}

TEST_F(ErrorControlService, HeartbeatProducerIgnoresGuardingRequests) {
    verifies<req::CO_GUARD_003, req::CO_GUARD_008>();
    write("603#2B0C100064000000");
    write("603#2F0D100001000000");
    send("703#R1");
    write("603#2B171000F4010000");
    EXPECT_TRUE(send("703#R1").empty());
    EXPECT_EQ(pass(600), (Frames{"500:703#7F"}));
}

TEST_F(ErrorControlService, NodeGuardingIdentifier100EhAppliesToGuardingHeartbeatAndBootUp) {
    verifies<req::CO_GUARD_004, req::AO4_GUARD_001, req::AO4_OD_100E>();
    write("603#230E100020070000");  // 100Eh node guarding identifier: 720h
    EXPECT_EQ(send("720#R1"), (Frames{"720#7F"}));
    EXPECT_TRUE(send("703#R1").empty());
    write("603#2B17100064000000");
    EXPECT_EQ(pass(100), (Frames{"100:720#7F"}));
    write("603#2310100173617665");
    EXPECT_EQ(power_on(), (Frames{"720#00"}));
}

TEST_F(SlaveErrorControl, WithoutNodeGuardingIdentifier100EhErrorControlUses700hPlusNodeId) {
    verifies<req::CO_GUARD_004, req::CO_K_GUARDING_ID>();
    EXPECT_EQ(send("605#400E100000000000"), (Frames{"585#800E100000000206"}));  // no such object
    EXPECT_EQ(send("705#R1"), (Frames{"705#7F"}));
    EXPECT_TRUE(send("700#R1").empty());
    EXPECT_EQ(send("605#2B17100064000000"), (Frames{"585#6017100000000000"}));
    EXPECT_EQ(pass(100), (Frames{"100:705#7F"}));
    node_id = 0x2A;
    EXPECT_EQ(power_on(), (Frames{"72A#00"}));
}

TEST_F(ErrorControlService, RestrictedNodeGuardingIdentifiersAreRefusedExceptThoseOfErrorControl) {
    verifies<req::CO_GUARD_005, req::AO4_GUARD_002, req::AO4_GUARD_005>();
    // These identifiers are refused: 000h NMT, 001h, 583h and 603h SDO, 6E0h, 780h, 7E5h LSS, 800h, and each value with
    // bit 29 or 31.
    for (const char* value : {"00000000", "01000000", "83050000", "03060000", "E0060000", "80070000", "E5070000",
                              "00080000", "03070020", "03070080", "85010020", "85010080"}) {
        EXPECT_EQ(send(std::string{"603#230E1000"} + value), (Frames{"583#800E100030000906"})) << value;
    }
    for (const char* value : {"01070000", "7F070000", "85010000"}) {
        write(std::string{"603#230E1000"} + value);
    }
}

namespace {

/// Returns the NMT state after a heartbeat error. `begin` is the NMT command that sets the state before the error,
/// `reaction` the value of 1029h:1 (error behaviour).
std::string state_after_error(const std::string& begin, const std::string& reaction) {
    CbxBench bench;
    bench.power_on();
    bench.write("603#23161001C8003100");
    bench.write("603#2F291001" + reaction + "000000");
    bench.send("000#" + begin + "03");
    bench.send("731#05");
    bench.pass(300);
    return bench.send("703#R1").at(0).substr(4);
}

/// Returns the state of an operational node after a guarding error; `reaction` is the value of 1029h:1 (error
/// behaviour).
NmtState state_after_guarding_error(const std::string& reaction) {
    CbxBench bench;
    bench.power_on();
    bench.write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    bench.write("603#2F0D100002000000");  // 100Dh life time factor: 2
    bench.write("603#2F291001" + reaction + "000000");
    bench.send("000#0103");
    bench.send("703#R1");
    bench.pass(199);
    EXPECT_EQ(bench.device->state(), NmtState::operational);
    bench.pass(1);
    return bench.device->state();
}

/// Returns the state of an operational node after bus-off; `reaction` is the value of 1029h:1 (error behaviour).
NmtState state_after_bus_off(const std::string& reaction) {
    CbxBench bench;
    bench.power_on();
    bench.write("603#2F291001" + reaction + "000000");
    bench.send("000#0103");
    bench.inputs.can_state = 3;
    bench.set_inputs();
    return bench.device->state();
}

}  // namespace

TEST(ErrorBehaviour, HeartbeatErrorChangesTheNmtStateAsErrorBehaviour1029hRequires) {
    verifies<req::CO_NMT_007, req::AO4_GUARD_003, req::AO4_GUARD_004, req::AO4_OD_1029>();
    EXPECT_EQ(state_after_error("01", "00"), "7F");  // 1029h:1 = 0: from operational to pre-operational
    EXPECT_EQ(state_after_error("01", "01"), "05");  // 1029h:1 = 1: no change of state
    EXPECT_EQ(state_after_error("01", "02"), "04");  // 1029h:1 (error behaviour) = 2: stopped
    EXPECT_EQ(state_after_error("80", "00"), "7F");
    EXPECT_EQ(state_after_error("02", "00"), "04");  // a stopped node stays stopped
    EXPECT_EQ(state_after_error("80", "02"), "04");
}

TEST(ErrorBehaviour, GuardingErrorAndBusOffChangeTheNmtStateAsErrorBehaviour1029hRequires) {
    verifies<req::CO_NMT_007, req::AO4_GUARD_003, req::AO4_OD_1029>();
    for (const auto state_after : {state_after_guarding_error, state_after_bus_off}) {
        EXPECT_EQ(state_after("00"), NmtState::pre_operational);
        EXPECT_EQ(state_after("01"), NmtState::operational);
        EXPECT_EQ(state_after("02"), NmtState::stopped);
    }
}

TEST_F(ErrorControlService, EachCommunicationErrorLeadsToPreOperationalEvenWhileAnotherLasts) {
    verifies<req::CO_NMT_007, req::AO4_GUARD_003>();
    write("603#23161001C8003100");  // 1016h:1 consumer heartbeat time: node 31h, 200 ms
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100001000000");  // 100Dh life time factor: 1
    send("000#0103");
    send("731#05");
    pass(200);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    send("000#0103");  // the master starts the node although the monitored producer is silent
    send("703#R1");
    pass(99);
    EXPECT_EQ(device->state(), NmtState::operational);
    pass(1);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    send("000#0103");
    inputs.can_state = 3;
    set_inputs();
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(ErrorControlService, BusOffLeadsToPreOperationalByDefault) {
    verifies<req::CO_NMT_007, req::AO4_GUARD_003>();
    send("000#0103");
    inputs.can_state = 3;
    EXPECT_TRUE(set_inputs().empty());
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    // The end of bus-off is reported with the errors that arose in bus-off: 8120h (error passive), 8140h (recovered
    // from bus-off), and the end of 8120h.
    inputs.can_state = 0;
    EXPECT_EQ(set_inputs(), (Frames{"083#2081110100000000", "083#4081110200000000", "083#0000000200000000"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

}  // namespace canproof::test
