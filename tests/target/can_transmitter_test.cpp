// SPDX-License-Identifier: Apache-2.0
// Tests how frames move from the transmit queue into the three mailboxes of the CAN controller, with a model of its
// registers.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/mailbox_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

}  // namespace

TEST(CanTransmitter, FrameIsSentAsQueued) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    Frame frame = data_frame(0x583, 8);
    frame.data = {0x43, 0x00, 0x10, 0x00, 0x91, 0x01, 0x08, 0xFF};
    bench.queue.push(frame);
    Frame remote = data_frame(0x702, 1);
    remote.remote = true;
    bench.queue.push(remote);
    bench.serve();
    const auto first = bench.model.transmit();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->id, 0x583U);
    EXPECT_EQ(first->length, 8U);
    EXPECT_EQ(first->data, frame.data);
    const auto second = bench.model.transmit();
    ASSERT_TRUE(second);
    EXPECT_TRUE(second->remote);
    EXPECT_FALSE(bench.model.transmit());
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanTransmitter, IdentifierOf29BitsKeepsItsBits) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    Frame frame = data_frame(0x1ABCDEF5, 0);
    frame.extended = true;
    bench.queue.push(frame);
    bench.serve();
    const auto sent = bench.model.transmit();
    ASSERT_TRUE(sent);
    EXPECT_TRUE(sent->extended);
    EXPECT_EQ(sent->id, 0x1ABCDEF5U);
}

TEST(CanTransmitter, LowestIdentifierIsSentFirstAndEqualIdentifiersInTheirOrder) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x183, 2}, {0x583, 3}, {0x083, 4}, {0x183, 5}, {0x583, 6}});
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x083, 4), Pair(0x183, 2), Pair(0x183, 5), Pair(0x583, 1),
                                          Pair(0x583, 3), Pair(0x583, 6)));
}

TEST(CanTransmitter, FreeMailboxBelowAWaitingFrameOfTheSameIdentifierIsNotUsed) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    // 083h is in mailbox 0, 583h #1 and #2 are in mailboxes 1 and 2. When 083h has been sent, mailbox 0 must stay free:
    // 583h #3 in mailbox 0 would be sent before 583h #1.
    bench.queue_up({{0x083, 1}, {0x583, 1}, {0x583, 2}, {0x583, 3}, {0x583, 4}});
    EXPECT_THAT(bench.sent(),
                ElementsAre(Pair(0x083, 1), Pair(0x583, 1), Pair(0x583, 2), Pair(0x583, 3), Pair(0x583, 4)));
}

TEST(CanTransmitter, UrgentFrameReplacesTheLeastUrgentFrameOfTheMailboxes) {
    verifies<req::CO_CAN_012, req::CO_CAN_013>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x583, 2}, {0x703, 3}});
    bench.serve();
    EXPECT_TRUE(bench.queue.empty());
    bench.queue_up({{0x083, 4}});
    bench.serve();
    ASSERT_NE(bench.queue.front(), nullptr);
    EXPECT_EQ(bench.queue.front()->id, 0x703U);  // 703h has left its mailbox and is in the queue again
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x083, 4), Pair(0x583, 1), Pair(0x583, 2), Pair(0x703, 3)));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanTransmitter, FrameReturnedToTheQueuePrecedesOtherFramesOfItsIdentifier) {
    verifies<req::CO_CAN_006, req::CO_CAN_013>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x583, 2}, {0x583, 3}, {0x583, 4}});
    bench.serve();
    ASSERT_NE(bench.queue.front(), nullptr);
    // a frame does not displace a frame with its own identifier from a mailbox
    EXPECT_EQ(bench.queue.front()->data[0], 4);
    bench.queue_up({{0x083, 5}});
    EXPECT_THAT(bench.sent(),
                ElementsAre(Pair(0x083, 5), Pair(0x583, 1), Pair(0x583, 2), Pair(0x583, 3), Pair(0x583, 4)));
}

TEST(CanTransmitter, LateAbortDoesNotSendTheFrameTwice) {
    verifies<req::CO_CAN_013>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x583, 2}, {0x583, 3}});
    bench.serve();
    const auto on_bus = bench.model.begin_transmission();  // #1 is in the mailbox with the lowest number
    ASSERT_TRUE(on_bus);
    ASSERT_EQ(on_bus->data[0], 1);
    bench.model.end_transmission(true);
    ASSERT_TRUE(bench.model.begin_transmission());  // frame #2 is on the bus
    bench.model.end_transmission(true);
    const auto last = bench.model.begin_transmission();  // #3 is on the bus when urgent frames arrive
    ASSERT_EQ(last->data[0], 3);
    bench.queue_up({{0x083, 4}, {0x083, 5}, {0x083, 6}});
    bench.serve();
    bench.model.end_transmission(true);
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x083, 4), Pair(0x083, 5), Pair(0x083, 6)));
}

TEST(CanTransmitter, AbortedFrameOnTheBusIsSentAgainOnlyIfItsTransmissionFails) {
    verifies<req::CO_CAN_012, req::CO_CAN_013>();
    for (const bool sent : {true, false}) {
        MailboxBench bench;
        bench.queue_up({{0x583, 1}});
        bench.serve();
        ASSERT_TRUE(bench.model.begin_transmission());
        bench.queue_up({{0x183, 2}, {0x183, 3}, {0x083, 4}});
        // 083h #4 and 183h #2 fill the other two mailboxes. 183h #3 is more urgent only than 583h #1, which is on the
        // bus.
        bench.serve();
        bench.model.end_transmission(sent);
        const auto rest = bench.sent();
        if (sent) {
            EXPECT_THAT(rest, ElementsAre(Pair(0x083, 4), Pair(0x183, 2), Pair(0x183, 3)));
        } else {
            EXPECT_THAT(rest, ElementsAre(Pair(0x083, 4), Pair(0x183, 2), Pair(0x183, 3), Pair(0x583, 1)));
        }
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

TEST(CanTransmitter, AbortedFrameStaysInItsMailboxWhenTheQueueIsFull) {
    verifies<req::CO_CAN_013>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}});
    bench.serve();
    ASSERT_TRUE(bench.model.begin_transmission());
    bench.queue_up({{0x183, 1}, {0x183, 2}, {0x083, 3}});
    bench.serve();  // requests the abort of 583h
    for (int i = 0; bench.queue.size() < TransmitQueue::capacity; ++i) {
        bench.queue_up({{0x703, i}});
    }
    bench.model.end_transmission(false);
    const auto rest = bench.sent();
    // 183h #2 was still in the queue and took the place of one frame 703h
    ASSERT_EQ(rest.size(), 4 + TransmitQueue::capacity - 1);
    EXPECT_EQ(std::count(rest.begin(), rest.end(), (std::pair<std::uint32_t, int>{0x583, 1})), 1);
    EXPECT_EQ(rest.front(), (std::pair<std::uint32_t, int>{0x083, 3}));
}

TEST(CanTransmitter, UrgentFrameInAFullQueueIsSentFirst) {
    verifies<req::CO_CAN_012, req::CO_CAN_013>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x583, 2}, {0x583, 3}});
    bench.serve();
    for (int i = 0; bench.queue.size() + 1 < TransmitQueue::capacity; ++i) {
        bench.queue_up({{0x703, i}});
    }
    bench.queue_up({{0x083, 4}});
    const auto sent = bench.sent();
    ASSERT_EQ(sent.size(), 3 + TransmitQueue::capacity);
    EXPECT_THAT(std::vector(sent.begin(), sent.begin() + 4),
                ElementsAre(Pair(0x083, 4), Pair(0x583, 1), Pair(0x583, 2), Pair(0x583, 3)));
}

TEST(CanTransmitter, NothingOvertakesTheBootUpMessage) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    MailboxBench bench;
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.serve();
    bench.queue_up({{0x083, 1}, {0x183, 2}});
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x703, 0), Pair(0x083, 1), Pair(0x183, 2)));
}

TEST(CanTransmitter, ResetDropsFramesInTheMailboxes) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x583, 2}, {0x583, 3}});
    bench.serve();
    ASSERT_TRUE(bench.model.begin_transmission());
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.queue_up({{0x083, 5}});
    bench.serve();
    bench.model.end_transmission(false);  // the transmission of 583h fails, and it is not repeated
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x703, 0), Pair(0x083, 5)));
}

TEST(CanTransmitter, NewBitRateDropsFramesInTheMailboxes) {
    verifies<req::CO_CAN_001, req::CO_CAN_006>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}, {0x583, 2}});
    bench.serve();
    bench.can.set_bit_rate(125000, bench.now);
    bench.serve();
    bench.serve();
    ASSERT_TRUE(bench.can.is_on_bus());
    bench.queue_up({{0x703, 3}});
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x703, 3)));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanTransmitter, BusOffReturnsTheFramesOfTheMailboxesToTheQueue) {
    verifies<req::CO_CAN_018>();
    MailboxBench bench;
    bench.queue_up({{0x083, 1}, {0x583, 2}, {0x583, 3}, {0x583, 4}});
    bench.serve();
    ASSERT_TRUE(bench.model.transmit());  // 083h has been sent; 583h #2 and #3 are in mailboxes, #4 is in the queue
    bench.model.count_errors(256, 0);
    bench.serve();
    std::vector<int> back;
    while (!bench.queue.empty()) {
        back.push_back(bench.queue.pop().data[0]);
    }
    EXPECT_THAT(back, ElementsAre(2, 3, 4));
    bench.serve();
    EXPECT_TRUE(bench.queue.empty());  // each frame returns only once
}

TEST(CanTransmitter, BusOffReturnsAnEmergencyMessageAlsoToAFullQueue) {
    verifies<req::CO_CAN_018>();
    MailboxBench bench;
    bench.queue_up({{0x083, 1}, {0x083, 2}});
    bench.serve();
    for (int i = 0; bench.queue.size() < TransmitQueue::capacity; ++i) {
        bench.queue_up({{0x703, i}});
    }
    bench.model.count_errors(256, 0);
    bench.serve();
    EXPECT_EQ(bench.queue.size(), TransmitQueue::capacity);
    EXPECT_EQ(bench.queue.count(0x083), 2U);
    EXPECT_EQ(bench.queue.pop().data[0], 1);
    EXPECT_EQ(bench.queue.pop().data[0], 2);
}

TEST(CanTransmitter, FramesFromBeforeABusOffAreNotSentAfterIt) {
    verifies<req::CO_CAN_006, req::CO_CAN_008>();
    MailboxBench bench;
    bench.queue_up({{0x583, 1}});
    bench.serve();
    bench.model.count_errors(256, 0);
    bench.serve();
    bench.queue.close();              // the node does this when it reads the state of the controller
    for (int i = 0; i < 1010; ++i) {  // 1010 steps are 101 ms
        bench.serve();
    }
    bench.model.pass_recessive(128);
    bench.queue.open();
    EXPECT_THAT(bench.sent(), IsEmpty());
    bench.queue_up({{0x703, 3}});
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x703, 3)));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

}  // namespace canproof::test
