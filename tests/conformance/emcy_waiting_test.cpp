// SPDX-License-Identifier: Apache-2.0
// Tests emergency messages that wait in the transmit queue when the node empties this queue (CiA 301, 7.2.7; CiA 305,
// 6.4.4). The node does so when a bus-off begins, at a reset of the communication and at a change of the bit rate. The
// tests use the conformance slave, node 5.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/lss_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class EmcyInTheQueue : public testing::Test, public LssBench {
  protected:
    /// Calls `act` while the bus carries nothing, so that the frames of the slave wait in its queue.
    template <typename Act>
    void while_blocked(const Act& act) {
        is_blocked = true;
        act();
        is_blocked = false;
    }
    void overrun_at_once(bool lost) { device->node().set_overrun(lost, now); }
    void can_at_once(CanState state) { device->node().set_can_state(state, now); }
    Frames recover() {
        can_at_once(CanState::error_active);
        return sent();
    }
};

}  // namespace

/// The usual way to bus-off: a disturbed bus makes the controller error passive, and nothing can be sent.
TEST_F(EmcyInTheQueue, ErrorPassiveThatCouldNotBeSentBeforeBusOffIsSentAfterIt) {
    verifies<req::CO_EMCY_035, req::CO_EMCY_015>();
    can_at_once(CanState::error_passive);
    can_at_once(CanState::bus_off);
    EXPECT_EQ(sent(), Frames{});
    EXPECT_EQ(pass(1000), Frames{});
    // 8120h (error passive), 8140h (recovered from bus-off), end of 8120h
    EXPECT_EQ(recover(), (Frames{"085#2081110100000000", "085#4081110200000000", "085#0000000200000000"}));
    EXPECT_EQ(pass(1000), Frames{});
}

TEST_F(EmcyInTheQueue, EndOfAnErrorThatCouldNotBeSentBeforeBusOffIsSentAfterIt) {
    verifies<req::CO_EMCY_035, req::CO_EMCY_028>();
    overrun_at_once(true);
    EXPECT_EQ(sent(), (Frames{"085#1081110100000000"}));
    overrun_at_once(false);
    can_at_once(CanState::bus_off);
    // the end of 8110h (overrun) comes first; then as in the test above
    EXPECT_EQ(recover(),
              (Frames{"085#0000110200000000", "085#2081110200000000", "085#4081110300000000", "085#0000000300000000"}));
}

/// 1015h (inhibit time EMCY) is 100 ms: 8110h (overrun) is in the queue, 8120h (error passive) waits behind it.
TEST_F(EmcyInTheQueue, MessageInTheQueueGoesBeforeOneThatTheInhibitTimeDelays) {
    verifies<req::CO_EMCY_035>();
    send("605#2B151000E8030000");
    while_blocked([&] {
        overrun_at_once(true);
        can_at_once(CanState::error_passive);
    });
    can_at_once(CanState::bus_off);
    EXPECT_EQ(recover(), Frames{});  // the inhibit time has not ended
    EXPECT_THAT(pass(150), testing::ElementsAre(testing::HasSubstr("085#1081")));
    EXPECT_THAT(pass(100), testing::ElementsAre(testing::HasSubstr("085#2081")));
}

/// 1015h (inhibit time EMCY) is 100 ms: the begin of 8110h (overrun) is in the queue, and the begin of 8120h (error
/// passive) and the end of 8110h wait behind it.
TEST_F(EmcyInTheQueue, MessageInTheQueueGoesBeforeALaterOneOfTheSameError) {
    verifies<req::CO_EMCY_035, req::CO_EMCY_006>();
    send("605#2B151000E8030000");
    while_blocked([&] {
        overrun_at_once(true);
        can_at_once(CanState::error_passive);
        overrun_at_once(false);
    });
    can_at_once(CanState::bus_off);
    EXPECT_EQ(recover(), Frames{});  // the inhibit time has not ended
    using testing::HasSubstr;
    // then 8140h (recovered from bus-off) and the end of 8120h
    EXPECT_THAT(pass(1000), testing::ElementsAre(HasSubstr("085#1081"), HasSubstr("085#2081"), HasSubstr("085#0000"),
                                                 HasSubstr("085#4081"), HasSubstr("085#0000")));
}

TEST_F(EmcyInTheQueue, MessageIsDroppedByBusOffWhenEmcyIsSwitchedOff) {
    verifies<req::CO_EMCY_002>();
    while_blocked([&] {
        overrun_at_once(true);
        send("605#2314100085000080");  // 1014h (COB-ID EMCY) with bit 31
    });
    can_at_once(CanState::bus_off);
    EXPECT_EQ(recover(), Frames{});
    EXPECT_EQ(pass(1000), Frames{});
}

/// 1015h (inhibit time EMCY) is 100 ms and saved. The reset ends the inhibit time of the first message.
TEST_F(EmcyInTheQueue, ErrorThatOutlastsResetNodeIsReportedWithoutInhibitTime) {
    verifies<req::CO_NMT_005, req::CO_EMCY_018>();
    send("605#2B151000E8030000");
    send("605#2310100173617665");  // 1010h:1 (save all parameters) with "save"
    overrun_at_once(true);
    EXPECT_EQ(sent(), (Frames{"085#1081110100000000"}));
    EXPECT_EQ(send("000#8105"), (Frames{"705#00", "085#1081110100000000"}));
}

TEST_F(EmcyInTheQueue, MessageThatWasSentBeforeBusOffIsNotSentAgain) {
    verifies<req::CO_EMCY_035, req::CO_EMCY_029>();
    overrun_at_once(true);
    EXPECT_EQ(sent(), (Frames{"085#1081110100000000"}));
    can_at_once(CanState::bus_off);
    EXPECT_EQ(recover(), (Frames{"085#2081110200000000", "085#4081110300000000", "085#0000110300000000"}));
}

TEST_F(EmcyInTheQueue, AtMostTwoMessagesOfAnErrorWaitDuringBusOff) {
    verifies<req::CO_EMCY_035, req::CO_EMCY_006, req::CO_EMCY_022>();
    for (const bool lost : {true, false, true, false, true}) {
        overrun_at_once(lost);
    }
    EXPECT_EQ(queue.size(), 5U);
    can_at_once(CanState::bus_off);
    const Frames frames = recover();
    EXPECT_EQ(std::count(frames.begin(), frames.end(), "085#1081110400000000"), 1);
    EXPECT_EQ(frames.size(), 4U);  // one message of 8110h (overrun), 8120h, 8140h, end of 8120h
}

TEST_F(EmcyInTheQueue, MessageThatWaitsWhenTheCommunicationIsResetFollowsTheBootUpMessage) {
    verifies<req::CO_EMCY_035, req::CO_EMCY_018>();
    overrun_at_once(true);
    EXPECT_EQ(send("000#8205"), (Frames{"705#00", "085#1081110000000000"}));
    EXPECT_EQ(pass(1000), Frames{});
}

TEST_F(EmcyInTheQueue, MessageThatWaitsWhenTheNodeIsResetIsSentOnce) {
    verifies<req::CO_NMT_005>();
    overrun_at_once(true);
    EXPECT_EQ(send("000#8105"), (Frames{"705#00", "085#1081110100000000"}));
}

TEST_F(EmcyInTheQueue, MessageThatWaitsWhenTheBitRateChangesIsSentAfterTheChange) {
    verifies<req::CO_EMCY_035, req::CO_LSS_015>();
    send("7E5#0401000000000000");
    send("7E5#1300030000000000");
    overrun_at_once(true);
    EXPECT_EQ(send("7E5#1564000000000000"), Frames{});  // activate bit timing with a switch delay of 100 ms
    EXPECT_EQ(pass(1000), (Frames{"200:085#1081110100000000"}));
}

}  // namespace canproof::test
