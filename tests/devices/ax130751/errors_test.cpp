// SPDX-License-Identifier: Apache-2.0
// Tests the errors of the AX130751 on the bus: error register, error list, error behaviour, emergency messages (COB-ID
// 0FFh), heartbeat and guarding (manual, 3.2.2 to 3.2.13). Node 127.
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Errors : public Ax130751Test {
  protected:
    void SetUp() override {
        Ax130751Test::SetUp();
        write(0x1800, 5, 0, 2);  // switches off the event timer of TPDO1, whose frames these tests do not need
    }
    /// Makes the device monitor node `producer` with a heartbeat time of 100 ms. Sends one heartbeat of this node, then
    /// waits for the time-out.
    void lose(int slot, int producer) {
        EXPECT_EQ(write(0x1016, slot, (producer << 16) + 100, 4), "");
        send(fmt::format("7{:02X}#05", producer));
        pass(100);
    }
};

}  // namespace

// AX130751, 3.2.4, Table 23
TEST_F(Ax130751Errors, LostHeartbeatIsListedWithItsProducer) {
    verifies<req::AOR_ERR_001, req::AOR_ERR_002, req::AOR_ERR_012, req::AOR_ERR_003, req::AOR_ERR_013, req::AOR_ERR_010,
             req::AOR_ERR_016, req::AOR_DIAG_010, req::AOR_T23, req::AOR_HB_001, req::AOR_OD_1001, req::AOR_OD_1003,
             req::AOR_OD_1016, req::AOR_ERR_017, req::CO_EMCY_009, req::CO_K_EMCY_ID, req::AOR_HB_003>();
    EXPECT_EQ(write(0x1016, 4, 0x00FFFFFF, 4), "");          // node-ID 255 is unused: it monitors nothing
    EXPECT_EQ(write(0x1016, 4, 0x01000000, 4), "06090031");  // the upper bits are reserved
    EXPECT_EQ(write(0x1016, 4, 0, 4), "");
    EXPECT_EQ(write(0x1016, 1, 0x00200064, 4), "");  // 1016h:1 consumer heartbeat time: node 32, 100 ms
    EXPECT_EQ(pass(500), Frames{});                  // node 32 is not monitored before its first heartbeat
    send("720#05");
    EXPECT_EQ(pass(99), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#3081012080000000"}));
    EXPECT_EQ(read(0x1001, 0), 1U);
    EXPECT_EQ(read(0x1003, 0), 1U);
    EXPECT_EQ(read(0x1003, 1), 0x80208130U);
    EXPECT_EQ(send("720#05"), (Frames{"0FF#0000000000000000"}));
    EXPECT_EQ(read(0x1001, 0), 0U);
    EXPECT_EQ(read(0x1003, 0), 0U);
    EXPECT_EQ(refusal(0x1014, 0), "06020000");
    EXPECT_EQ(refusal(0x1015, 0), "06020000");
}

// Section 3.2.9: the device monitors four producers, each with its own heartbeat time
TEST_F(Ax130751Errors, EachOfFourProducersIsMonitoredFromItsFirstHeartbeat) {
    verifies<req::AOR_HB_001, req::AOR_OD_1016, req::AOR_HB_003>();
    for (int slot = 1; slot <= 4; ++slot) {
        EXPECT_EQ(write(0x1016, slot, ((0x20 + slot) << 16) + (100 * slot), 4), "");
    }
    EXPECT_EQ(pass(500), Frames{}) << "none was heard";
    send("724#05");
    EXPECT_EQ(pass(399), Frames{}) << "the others were not heard";
    EXPECT_EQ(pass(1), (Frames{"1:0FF#3081012480000000"}));
    EXPECT_EQ(send("724#05"), (Frames{"0FF#0000000000000000"}));
    for (const char* heartbeat : {"723#05", "722#05", "721#05"}) {
        EXPECT_EQ(send(heartbeat), Frames{});
    }
    EXPECT_EQ(pass(400), (Frames{"100:0FF#3081012180000000", "200:0FF#3081012280000000", "300:0FF#3081012380000000",
                                 "400:0FF#3081012480000000"}));
}

TEST_F(Ax130751Errors, ErrorListHasTheActiveErrorsNewestFirst) {
    verifies<req::AOR_ERR_002, req::AOR_ERR_012, req::AOR_ERR_003, req::AOR_ERR_013, req::AOR_OD_1003,
             req::AOR_OD_1016>();
    lose(1, 0x21);
    lose(2, 0x22);
    lose(3, 0x23);
    EXPECT_EQ(read(0x1003, 0), 3U);
    EXPECT_EQ(read(0x1003, 1), 0x80238130U);
    EXPECT_EQ(read(0x1003, 2), 0x80228130U);
    EXPECT_EQ(read(0x1003, 3), 0x80218130U);
    // The second of the three errors ends: the entries of the others move up, and bit 0 of 1001h (error register) stays
    // set.
    EXPECT_EQ(send("722#05"), (Frames{"0FF#0000010000000000"}));
    EXPECT_EQ(read(0x1003, 0), 2U);
    EXPECT_EQ(read(0x1003, 1), 0x80238130U);
    EXPECT_EQ(read(0x1003, 2), 0x80218130U);
    EXPECT_EQ(read(0x1003, 3), 0U);
    EXPECT_EQ(read(0x1001, 0), 1U);
}

TEST_F(Ax130751Errors, FifthErrorRemovesTheOldestFromTheList) {
    verifies<req::AOR_ERR_002, req::AOR_ERR_012, req::AOR_ERR_004, req::AOR_OD_1003>();
    lose(1, 0x21);
    lose(2, 0x22);
    lose(3, 0x23);
    lose(4, 0x24);
    start();
    send("27F#00");  // RPDO1 is too short: 8210h
    EXPECT_EQ(read(0x1003, 0), 4U);
    EXPECT_EQ(read(0x1003, 1), 0x00008210U);
    EXPECT_EQ(read(0x1003, 2), 0x80248130U);
    EXPECT_EQ(read(0x1003, 4), 0x80228130U);
    // The four listed errors end. The oldest error, which the full list has dropped, is still active: bit 0 of 1001h
    // (error register) stays set.
    send("27F#0000000000");
    send("722#05");
    send("723#05");
    send("724#05");
    EXPECT_EQ(read(0x1003, 0), 0U);
    EXPECT_EQ(read(0x1001, 0), 1U);
    send("721#05");
    EXPECT_EQ(read(0x1001, 0), 0U);
}

TEST_F(Ax130751Errors, ClearingTheErrorListEndsNoError) {
    verifies<req::AOR_ERR_005, req::AOR_ERR_014, req::AOR_OD_1003, req::AOR_OD_1001, req::AOR_ERR_018>();
    lose(1, 0x21);
    for (int value = 1; value <= 5; ++value) {
        EXPECT_EQ(write(0x1003, 0, value, 1), "06090030") << value;
    }
    EXPECT_EQ(read(0x1003, 0), 1U);
    EXPECT_EQ(write(0x1003, 0, 0, 1), "");
    EXPECT_EQ(read(0x1003, 0), 0U);
    EXPECT_EQ(read(0x1003, 1), 0U);
    EXPECT_EQ(read(0x1001, 0), 1U);
    pass(1000);
    EXPECT_EQ(read(0x1003, 0), 0U);  // the error is still active, but it is not entered into the list again
    send("721#05");
    EXPECT_EQ(read(0x1001, 0), 0U);
    pass(100);
    EXPECT_EQ(read(0x1003, 0), 1U);
}

TEST_F(Ax130751Errors, HeartbeatErrorChangesTheNmtStateByErrorBehaviour1029hSub1Only) {
    verifies<req::AOR_ERR_006, req::AOR_ERR_007, req::AOR_OD_1029, req::AOR_ERR_022>();
    struct Case {
        int behaviour;
        NmtState operational;      ///< new state of an operational node
        NmtState pre_operational;  ///< new state of a pre-operational node
    };
    const std::vector<Case> cases{
        {0, NmtState::pre_operational, NmtState::pre_operational},
        {1, NmtState::operational, NmtState::pre_operational},
        {2, NmtState::stopped, NmtState::stopped},
    };
    int producer = 0x20;
    for (const Case& one : cases) {
        for (const bool started : {false, true}) {
            send("000#807F");
            EXPECT_EQ(write(0x1029, 1, one.behaviour, 1), "");
            for (int sub = 2; sub <= 5; ++sub) {
                // 1029h:2 to 1029h:5 differ from 1029h:1, so that the test notices a wrong sub-index
                EXPECT_EQ(write(0x1029, sub, one.behaviour == 1 ? 2 : 1, 1), "");
            }
            EXPECT_EQ(write(0x1016, 1, (producer << 16) + 100, 4), "");
            send(fmt::format("7{:02X}#05", producer));
            ++producer;
            if (started) {
                start();
            }
            pass(100);
            EXPECT_EQ(device->state(), started ? one.operational : one.pre_operational) << one.behaviour << started;
        }
    }
}

TEST_F(Ax130751Errors, ErrorBehaviour1029hSub2To5KeepTheWrittenValues) {
    verifies<req::AOR_ERR_007>();
    for (int first = 0; first <= 2; ++first) {
        for (int sub = 2; sub <= 5; ++sub) {
            EXPECT_EQ(write(0x1029, sub, (first + sub) % 3, 1), "");
        }
        for (int sub = 2; sub <= 5; ++sub) {
            EXPECT_EQ(read(0x1029, sub), static_cast<std::uint64_t>((first + sub) % 3)) << first << " " << sub;
        }
    }
}

// Section 3.2.9: a lost heartbeat changes the NMT state, for each of the four monitored producers.
TEST_F(Ax130751Errors, EachCommunicationErrorLeadsToPreOperationalAlsoWhileAnotherLasts) {
    verifies<req::AOR_ERR_006>();
    EXPECT_EQ(write(0x1029, 1, 0, 1), "");
    for (int slot = 1; slot <= 4; ++slot) {
        start();
        lose(slot, 0x20 + slot);
        EXPECT_EQ(device->state(), NmtState::pre_operational) << slot;
    }
    EXPECT_EQ(write(0x100C, 0, 50, 2), "");
    EXPECT_EQ(write(0x100D, 0, 2, 1), "");
    EXPECT_EQ(write(0x1400, 5, 100, 2), "");  // 1400h:5 event timer of RPDO1: 100 ms
    EXPECT_EQ(write(0x1403, 5, 100, 2), "");  // 1403h:5 event timer of RPDO4: 100 ms
    for (const char* heard_once : {"77F#R", "27F#0000000000", "57F#0000"}) {
        start();
        send(heard_once);
        pass(99);
        EXPECT_EQ(device->state(), NmtState::operational) << heard_once;
        pass(1);
        EXPECT_EQ(device->state(), NmtState::pre_operational) << heard_once;
    }
}

TEST_F(Ax130751Errors, StoppedNodeStaysStoppedAtAHeartbeatError) {
    verifies<req::AOR_ERR_006>();
    EXPECT_EQ(write(0x1029, 1, 0, 1), "");
    EXPECT_EQ(write(0x1016, 1, 0x00200064, 4), "");
    send("720#05");
    send("000#027F");
    pass(200);
    EXPECT_EQ(device->state(), NmtState::stopped);
}

// Sections 3.2.5, 3.2.6: life time = guard time (100 ms) × life time factor (2)
TEST_F(Ax130751Errors, LifeGuardingFailsWithoutRequestsAndIsOffWithAHeartbeat) {
    verifies<req::AOR_GUARD_001, req::AOR_DIAG_010, req::AOR_T23, req::AOR_OD_100C, req::AOR_OD_100D,
             req::AOR_GUARD_002>();
    EXPECT_EQ(write(0x100C, 0, 100, 2), "");
    EXPECT_EQ(write(0x100D, 0, 2, 1), "");
    EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
    EXPECT_EQ(pass(199), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:0FF#3081010010000000"}));
    EXPECT_EQ(read(0x1003, 1), 0x10008130U);
    EXPECT_EQ(send("77F#R"), (Frames{"0FF#0000000000000000", "77F#FF"}));

    EXPECT_EQ(write(0x100D, 0, 0, 1), "");  // 100Dh life time factor 0: life guarding is off
    EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
    EXPECT_EQ(pass(1000), Frames{});
    EXPECT_EQ(write(0x100D, 0, 2, 1), "");
    EXPECT_EQ(write(0x100C, 0, 0, 2), "");  // 100Ch guard time 0: life guarding is off too
    EXPECT_EQ(send("77F#R").size(), 1U);
    EXPECT_EQ(pass(1000), Frames{});

    EXPECT_EQ(write(0x100C, 0, 100, 2), "");
    EXPECT_EQ(write(0x1017, 0, 1000, 2), "");  // 1017h producer heartbeat time: 1000 ms; guarding is off
    EXPECT_EQ(send("77F#R"), Frames{});
    EXPECT_EQ(pass(999), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:77F#7F"}));
}

TEST_F(Ax130751Errors, HeartbeatThatIsSwitchedOnEndsTheLifeTimeThatRuns) {
    verifies<req::AOR_GUARD_001>();
    EXPECT_EQ(write(0x100C, 0, 100, 2), "");
    EXPECT_EQ(write(0x100D, 0, 2, 1), "");
    EXPECT_EQ(send("77F#R").size(), 1U);  // the life time of 200 ms begins
    EXPECT_EQ(pass(150), Frames{});
    EXPECT_EQ(write(0x1017, 0, 1000, 2), "");
    EXPECT_EQ(pass(999), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:77F#7F"}));
}

// AX130751, 3.2.10
TEST_F(Ax130751Errors, ShortestHeartbeatPeriodIsTenMilliseconds) {
    verifies<req::AOR_HB_002, req::AOR_OD_1017>();
    for (int time = 1; time <= 9; ++time) {
        EXPECT_EQ(write(0x1017, 0, time, 2), "06090032") << time;
    }
    EXPECT_EQ(pass(100), Frames{});
    EXPECT_EQ(write(0x1017, 0, 10, 2), "");
    EXPECT_EQ(pass(30), (Frames{"10:77F#7F", "20:77F#7F", "30:77F#7F"}));
    EXPECT_EQ(write(0x1017, 0, 0, 2), "");
    EXPECT_EQ(pass(100), Frames{});
}

TEST_F(Ax130751Errors, CanControllerErrorsAreNotReported) {
    verifies<req::AOR_ERR_011, req::AOR_S_CAN_STATE, req::AOR_S_CAN_OVERRUN>();
    for (const int state : {2, 3, 0}) {  // CAN states error passive, bus-off, error active
        inputs.can_state = static_cast<std::uint8_t>(state);
        EXPECT_EQ(set_inputs(), Frames{});
    }
    inputs.can_overrun = true;
    EXPECT_EQ(set_inputs(), Frames{});
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(100), Frames{});
    EXPECT_EQ(read(0x1003, 0), 0U);
    EXPECT_EQ(read(0x1001, 0), 0U);
}

// Sections 3.2.13 and 3.4.86: the reaction to a communication fault (1029h:1) has priority over the self-start (5555h,
// Start in Operational Mode).
TEST_F(Ax130751Errors, SelfStartWithBusOffAtPowerOnLeadsToTheStateOfErrorBehaviour1029h) {
    verifies<req::AOR_START_003, req::AOR_START_006, req::AOR_ERR_006>();
    const std::vector<std::pair<int, NmtState>> states{
        {0, NmtState::pre_operational}, {1, NmtState::operational}, {2, NmtState::stopped}};
    EXPECT_EQ(write(0x5555, 0, 1, 1), "");
    for (const auto& [behaviour, state] : states) {
        SCOPED_TRACE(behaviour);
        EXPECT_EQ(write(0x1029, 1, behaviour, 1), "");
        store();
        inputs.can_state = 3;  // bus-off
        power_on();
        pass(1000);
        EXPECT_EQ(device->state(), state);
        inputs.can_state = 0;
        set_inputs();
        pass(1000);
        EXPECT_EQ(device->state(), state) << "the end of the fault starts nothing";
        start();
        EXPECT_EQ(device->state(), NmtState::operational);
        power_on();
        pass(1);
        EXPECT_EQ(device->state(), NmtState::operational) << "without the fault";
    }
}

// Section 3.2.7: the stored parameters are damaged behind their header
TEST_F(Ax130751Errors, DamagedStoredParametersAreReportedAndTheDefaultsApply) {
    verifies<req::AOR_ERR_009, req::AOR_T_NODE_ERRORS, req::AOR_ERR_021>();
    EXPECT_EQ(write(0x5032, 0, 99, 1), "");
    store();
    for (std::size_t at = 100; at < 110; ++at) {
        memory.bytes()[at] = static_cast<std::uint8_t>(memory.bytes()[at] + 1);
    }
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#0063010000000000"}));
    EXPECT_EQ(read(0x5032, 0), 85U);
    EXPECT_EQ(read(0x1003, 1), 0x00006300U);
    EXPECT_EQ(read(0x1001, 0), 1U);
    pass(1000);
    store();  // a sound set: the error still lasts until a reset of the node
    send("000#827F");
    EXPECT_EQ(read(0x1003, 1), 0x00006300U);
    EXPECT_EQ(read(0x1001, 0), 1U);
    send("000#817F");
    EXPECT_EQ(read(0x1003, 0), 0U);
    EXPECT_EQ(read(0x1001, 0), 0U);
}

// During bus-off the boot-up message is lost. The errors found at boot-up are not lost.
TEST_F(Ax130751Errors, DamagedStoredParametersFoundDuringBusOffAreReportedAfterBusOff) {
    verifies<req::CO_EMCY_031, req::AOR_ERR_021>();
    store();
    memory.bytes()[100] ^= 0x01;
    inputs.can_state = 3;
    EXPECT_EQ(power_on(), Frames{});
    EXPECT_EQ(pass(500), Frames{});
    inputs.can_state = 0;
    EXPECT_EQ(set_inputs(), (Frames{"0FF#0063010000000000"}));
}

}  // namespace canproof::test
