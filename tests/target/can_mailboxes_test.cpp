// SPDX-License-Identifier: Apache-2.0
// Tests which frames are in the three mailboxes of the CAN controller after one call of the driver. The model sends
// frames without further calls, as the hardware does while the main loop is busy.
#include <gmock/gmock.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/stm32f405/mailbox_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

}  // namespace

TEST(CanMailboxes, FrameKeepsItsKind) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    for (const bool remote : {false, true}) {
        Frame frame = data_frame(0x583, 2);
        frame.remote = remote;
        ASSERT_TRUE(bench.queue.push(frame));
        bench.serve();
        const auto sent = bench.model.transmit();
        ASSERT_TRUE(sent);
        EXPECT_EQ(sent->remote, remote);
        EXPECT_FALSE(sent->extended);
    }
}

TEST(CanMailboxes, FrameWithIdentifierZeroIsSent) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    bench.queue_up({{0x000, 1}, {0x000, 2}});
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x000, 1), Pair(0x000, 2)));
}

TEST(CanMailboxes, QueueKeepsItsFramesUntilTheControllerIsOnTheBus) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    bench.can.set_bit_rate(500000, bench.now);
    bench.queue_up({{0x583, 1}});
    bench.serve();
    EXPECT_FALSE(bench.can.is_on_bus());
    EXPECT_EQ(bench.queue.size(), 1U);
    EXPECT_THAT(bench.sent_at_once(), IsEmpty());
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x583, 1)));
}

TEST(CanMailboxes, NewBitRateAbortsTheFramesOfAllThreeMailboxes) {
    verifies<req::CO_CAN_001, req::CO_CAN_006>();
    MailboxBench bench;
    bench.fill({{0x583, 1}, {0x683, 2}, {0x703, 3}});
    bench.can.set_bit_rate(500000, bench.now);
    bench.serve();
    bench.serve();
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_THAT(bench.sent_at_once(), IsEmpty());
}

TEST(CanMailboxes, OneCallReplacesAllThreeFrames) {
    verifies<req::CO_CAN_012>();
    MailboxBench bench;
    bench.fill({{0x701, 1}, {0x702, 2}, {0x703, 3}});
    bench.queue_up({{0x081, 4}, {0x082, 5}, {0x083, 6}});
    bench.serve();
    EXPECT_EQ(bench.queue.size(), 3U);
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x081, 4), Pair(0x082, 5), Pair(0x083, 6)));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanMailboxes, LeastUrgentFrameIsReplacedInEachMailbox) {
    verifies<req::CO_CAN_012>();
    std::array<std::uint32_t, 3> ids{0x583, 0x683, 0x703};
    do {
        MailboxBench bench;
        bench.fill({{ids[0], 1}, {ids[1], 2}, {ids[2], 3}});
        bench.queue_up({{0x603, 4}});
        bench.serve();
        ASSERT_EQ(bench.queue.size(), 1U);
        EXPECT_EQ(bench.queue.front()->id, 0x703U);
        std::vector<std::uint32_t> sent;
        for (const Numbered& one : bench.sent_at_once()) {
            sent.push_back(one.first);
        }
        EXPECT_THAT(sent, ElementsAre(0x583, 0x603, 0x683));
    } while (std::next_permutation(ids.begin(), ids.end()));
}

TEST(CanMailboxes, FreeMailboxBelowAWaitingFrameOfAnotherIdentifierIsUsed) {
    verifies<req::CO_CAN_006>();
    MailboxBench bench;
    bench.fill({{0x083, 1}, {0x583, 2}, {0x703, 3}});
    ASSERT_TRUE(bench.model.transmit());  // 083h leaves mailbox 0
    bench.queue_up({{0x183, 4}});
    bench.serve();
    EXPECT_TRUE(bench.queue.empty());
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x183, 4), Pair(0x583, 2), Pair(0x703, 3)));
}

TEST(CanMailboxes, NoFrameIsReplacedWhileAMailboxIsFree) {
    verifies<req::CO_CAN_012>();
    MailboxBench bench;
    bench.fill({{0x083, 1}, {0x183, 2}, {0x703, 3}});
    ASSERT_TRUE(bench.model.transmit());  // 083h leaves mailbox 0, which 183h #4 cannot use: #2 is behind it
    bench.queue_up({{0x183, 4}});
    bench.serve();
    ASSERT_EQ(bench.queue.size(), 1U);
    EXPECT_EQ(bench.queue.front()->id, 0x183U);
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x183, 2), Pair(0x703, 3)));
}

TEST(CanMailboxes, ReplacedFrameDoesNotTakeTheMailboxThatItsReplacementCannotUse) {
    verifies<req::CO_CAN_013>();
    MailboxBench bench;
    bench.fill({{0x583, 1}, {0x183, 2}, {0x083, 3}});
    bench.queue_up({{0x183, 4}});
    bench.serve();
    EXPECT_EQ(bench.queue.size(), 2U);  // 183h #4 must not be below 183h #2
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x083, 3), Pair(0x183, 2)));
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x183, 4), Pair(0x583, 1)));
}

TEST(CanMailboxes, UrgentFrameOfAFullQueueTakesTheMailboxOfTheLeastUrgentFrame) {
    verifies<req::CO_CAN_012, req::CO_CAN_013>();
    MailboxBench bench;
    bench.fill({{0x583, 1}, {0x183, 2}, {0x083, 3}});
    bench.queue_up({{0x283, 4}});
    bench.fill_queue(0x703);
    bench.serve();
    ASSERT_EQ(bench.queue.size(), TransmitQueue::capacity);
    EXPECT_EQ(bench.queue.front()->id, 0x583U);
    // The frame that has taken the mailbox can be replaced too.
    static_cast<void>(bench.queue.pop());
    bench.queue_up({{0x203, 5}});
    bench.serve();
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x083, 3), Pair(0x183, 2), Pair(0x203, 5)));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanMailboxes, OneCallExchangesOneFrameOfAFullQueue) {
    shows_rule(
        "while its transmit queue is full, the CAN driver exchanges one frame in a call, so that a call stays short");
    MailboxBench bench;
    bench.fill({{0x581, 1}, {0x582, 2}, {0x583, 3}});
    bench.queue_up({{0x081, 4}, {0x082, 5}});
    bench.fill_queue(0x703);
    bench.serve();
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x081, 4), Pair(0x581, 1), Pair(0x582, 2)));
}

TEST(CanMailboxes, UrgentFrameOfAFullQueueStaysBehindAMailboxWithItsIdentifier) {
    verifies<req::CO_CAN_006, req::CO_CAN_013>();
    for (const std::size_t same : {1U, 2U}) {  // the mailbox with the identifier of the urgent frame
        MailboxBench bench;
        bench.fill({{0x583, 1}, {same == 1 ? 0x183 : 0x083, 2}, {same == 2 ? 0x183 : 0x083, 3}});
        bench.queue_up({{0x183, 4}});
        bench.fill_queue(0x703);
        bench.serve();
        const int first = same == 1 ? 3 : 2;  // the number of the frame 083h
        const int second = same == 1 ? 2 : 3;
        EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x083, first), Pair(0x183, second), Pair(0x583, 1)));
        ASSERT_EQ(bench.queue.size(), TransmitQueue::capacity);
        EXPECT_EQ(bench.queue.front()->data[0], 4);
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

/// Between the driver's look at the mailboxes and its abort, the two more urgent frames are sent and the frame to be
/// aborted comes onto the bus, where it then fails.
TEST(CanMailboxes, FrameOfAFullQueueTakesTheMailboxOfAFailedFrameWhenTheOthersAreFree) {
    verifies<req::CO_CAN_006, req::CO_CAN_013>();
    MailboxBench bench;
    bench.fill({{0x700, 1}, {0x100, 2}, {0x101, 3}});
    bench.fill_queue(0x600);
    const auto status = reinterpret_cast<std::uintptr_t>(&bench.model.registers().transmit_status);
    std::vector<std::uint32_t> on_bus;
    before_access = [&bench, &on_bus, status](const Access& access) {
        if (access.address == status && access.is_write && on_bus.empty()) {
            on_bus = {bench.model.transmit()->id, bench.model.transmit()->id, bench.model.begin_transmission()->id};
        }
    };
    bench.serve();
    before_access = nullptr;
    EXPECT_THAT(on_bus, testing::ElementsAre(0x100, 0x101, 0x700));
    bench.model.end_transmission(false);
    std::vector<Numbered> expected(TransmitQueue::capacity, Numbered{0x600, 99});
    expected.emplace_back(0x700, 1);
    EXPECT_EQ(bench.sent(), expected);
}

TEST(CanMailboxes, AbortedFrameIsSentBeforeAFullQueueOfLessUrgentFrames) {
    verifies<req::CO_CAN_006, req::CO_CAN_013>();
    for (const std::uint32_t id : {0x703U, 0x583U}) {  // a frame of its own identifier is also behind it
        MailboxBench bench;
        bench.fill({{0x583, 1}});
        ASSERT_TRUE(bench.model.begin_transmission());
        bench.fill({{0x083, 2}, {0x183, 3}});
        bench.queue_up({{0x283, 4}});
        bench.serve();  // requests the abort of 583h
        bench.empty_queue();
        bench.fill_queue(id);
        bench.model.end_transmission(false);
        bench.serve();
        EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x083, 2), Pair(0x183, 3), Pair(0x583, 1)));
    }
}

TEST(CanMailboxes, BootUpMessageTakesAMailboxInTheCallThatDropsTheOldFrames) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    MailboxBench bench;
    bench.fill({{0x583, 1}, {0x583, 2}, {0x683, 3}});
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.serve();
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x703, 0)));
}

TEST(CanMailboxes, ResetDropsFramesBehindAFreeMailbox) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    MailboxBench bench;
    bench.fill({{0x083, 1}, {0x583, 2}, {0x683, 3}});
    ASSERT_TRUE(bench.model.transmit());  // 083h leaves mailbox 0
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.serve();
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x703, 0)));
}

TEST(CanMailboxes, BootUpMessageWaitsForTheEndOfTheFrameOnTheBus) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    MailboxBench bench;
    bench.fill({{0x583, 1}});
    ASSERT_TRUE(bench.model.begin_transmission());
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.serve();
    EXPECT_TRUE(bench.queue.boot_up_waits());
    bench.model.end_transmission(true);
    bench.serve();
    EXPECT_THAT(bench.sent_at_once(), ElementsAre(Pair(0x703, 0)));
}

TEST(CanMailboxes, FrameThatIsReplacedAfterABootUpMessageIsSentLater) {
    verifies<req::CO_CAN_013, req::CO_NMT_001>();
    MailboxBench bench;
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x703, 0)));
    bench.fill({{0x583, 1}, {0x683, 2}, {0x683, 3}});
    bench.queue_up({{0x083, 4}, {0x083, 5}, {0x083, 6}});
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x083, 4), Pair(0x083, 5), Pair(0x083, 6), Pair(0x583, 1),
                                          Pair(0x683, 2), Pair(0x683, 3)));
}

/// The reset has aborted the frame on the bus. Then the boot-up message is lost, as at bus-off or when LSS changes the
/// bit rate, and the frame on the bus fails.
TEST(CanMailboxes, FrameThatAResetAbortedIsNotSentWithoutTheBootUpMessageEither) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    for (const bool bus_off : {false, true}) {
        MailboxBench bench;
        bench.fill({{0x083, 1}, {0x583, 2}});
        ASSERT_TRUE(bench.model.transmit());
        ASSERT_TRUE(bench.model.begin_transmission());  // 583h in mailbox 1
        bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
        bench.serve();
        bench.empty_queue();
        if (bus_off) {
            bench.model.count_errors(256, 0);
            bench.serve();
            EXPECT_EQ(bench.can.state(), CanState::bus_off);
            EXPECT_TRUE(bench.queue.empty());
        } else {
            bench.model.end_transmission(false);
            EXPECT_THAT(bench.sent(), IsEmpty());
        }
    }
}

TEST(CanMailboxes, FrameThatFailsBeforeTheDriverSeesTheResetIsDropped) {
    verifies<req::CO_CAN_006, req::CO_NMT_001>();
    MailboxBench bench;
    bench.fill({{0x583, 1}});
    ASSERT_TRUE(bench.model.begin_transmission());
    bench.fill({{0x183, 2}, {0x183, 3}});
    bench.queue_up({{0x083, 4}});
    bench.serve();  // requests the abort of 583h
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.model.end_transmission(false);
    EXPECT_THAT(bench.sent(), ElementsAre(Pair(0x703, 0)));
}

TEST(CanMailboxes, BusOffReturnsNoFrameFromBeforeAReset) {
    verifies<req::CO_CAN_018, req::CO_NMT_001>();
    MailboxBench bench;
    bench.fill({{0x583, 1}});
    bench.queue.push_boot_up(MailboxBench::frame({0x703, 0}));
    bench.model.count_errors(256, 0);
    bench.serve();
    ASSERT_EQ(bench.queue.size(), 1U);
    EXPECT_EQ(bench.queue.front()->id, 0x703U);
}

}  // namespace canproof::test
