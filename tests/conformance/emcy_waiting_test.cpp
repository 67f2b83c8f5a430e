// SPDX-License-Identifier: Apache-2.0
// Tests emergency messages that wait in the transmit queue when the node empties this queue (CiA 301, 7.2.7; CiA 305,
// 6.4.4). The node does so when a bus-off begins, at a reset of the communication and at a change of the bit rate. The
// first tests use the conformance slave, node 5.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/device_by_sdo.hpp"
#include "tests/support/every_device.hpp"
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

/// In each device, a missing heartbeat of node 9 is error 8130h.
TEST(EveryDevice, EmcyThatWaitsWhenBusOffBeginsIsSentAfterTheBusOff) {
    verifies<req::CO_EMCY_035>();
    for (const std::string& name : every_device()) {
        DeviceBySdo unit{name, 5};
        ASSERT_TRUE(unit.write(0x1016, 1, 4, 0x00090064)) << name;  // heartbeats of node 9 at least every 100 ms
        Frame heartbeat = data_frame(0x709, 1);
        heartbeat.data[0] = 0x05;
        unit.device->receive(heartbeat, Instant{});
        const Instant missing{100001};
        unit.device->advance(missing);
        unit.device->set_input("can_state", 3, missing);
        EXPECT_TRUE(unit.device->queue().empty()) << name;
        unit.device->set_input("can_state", 0, missing);
        int count = 0;
        while (!unit.device->queue().empty()) {
            const Frame frame = unit.device->queue().pop();
            count += frame.id == 0x085 && frame.data[0] == 0x30 && frame.data[1] == 0x81 ? 1 : 0;
        }
        EXPECT_EQ(count, 1) << name;
    }
}

}  // namespace canproof::test
