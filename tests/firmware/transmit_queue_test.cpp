// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/transmit_queue.hpp"

#include "firmware/base/crc32.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

Frame numbered(std::uint32_t id, std::uint8_t number) {
    Frame frame = data_frame(id, 1);
    frame.data[0] = number;
    return frame;
}

}  // namespace

TEST(Frames, RemoteFrameHasALengthAndNoData) {
    shows_rule("a remote frame carries no data");
    Frame frame = data_frame(0x703, 8);
    EXPECT_EQ(frame.payload().size(), 8U);
    frame.remote = true;
    EXPECT_EQ(frame.payload().size(), 0U);
}

TEST(TransmitQueueOrder, LowestIdentifierIsFirstAndEqualIdentifiersKeepTheirOrder) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    for (const auto& [id, number] : {std::pair{0x583U, 1}, {0x183U, 2}, {0x583U, 3}, {0x083U, 4}, {0x183U, 5}}) {
        ASSERT_TRUE(queue.push(numbered(id, static_cast<std::uint8_t>(number))));
    }
    for (const int expected : {4, 2, 5, 1, 3}) {
        EXPECT_EQ(queue.pop().data[0], expected);
    }
    EXPECT_TRUE(queue.empty());
}

TEST(TransmitQueueOrder, FramesWhoseIdentifiersDifferByOneAreSentLowestFirst) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    for (const std::uint32_t id : {0x184U, 0x183U, 0x185U, 0x182U}) {
        ASSERT_TRUE(queue.push(numbered(id, 0)));
    }
    for (const std::uint32_t id : {0x182U, 0x183U, 0x184U, 0x185U}) {
        EXPECT_EQ(queue.pop().id, id);
    }
}

TEST(TransmitQueueOrder, FramesOfHigherPriorityAreAcceptedUntilTheQueueIsFull) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    ASSERT_TRUE(queue.push(0x583, 1, 0xA1));
    for (std::size_t i = 1; i < TransmitQueue::capacity; ++i) {
        EXPECT_TRUE(queue.push(0x183, 1, i)) << "goes before 583h";
    }
    EXPECT_FALSE(queue.push(0x183, 1, 0xFF)) << "the queue is full";
    EXPECT_EQ(queue.size(), TransmitQueue::capacity);
    for (std::size_t i = 1; i < TransmitQueue::capacity; ++i) {
        EXPECT_EQ(queue.pop().data[0], i);
    }
    EXPECT_EQ(queue.pop().data[0], 0xA1);
}

TEST(TransmitQueueOrder, EmptyQueueGivesAnEmptyFrame) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    EXPECT_EQ(queue.pop().length, 0U);
    EXPECT_TRUE(queue.empty());
    ASSERT_TRUE(queue.push(numbered(0x583, 1)));  // the pop() of the empty queue has changed nothing
    EXPECT_EQ(queue.pop().data[0], 1);
}

TEST(TransmitQueueOrder, FrontShowsTheFrameThatPopReturns) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    EXPECT_EQ(queue.front(), nullptr);
    queue.push(numbered(0x583, 1));
    queue.push(numbered(0x083, 2));
    ASSERT_NE(queue.front(), nullptr);
    EXPECT_EQ(queue.front()->data[0], 2);
    EXPECT_EQ(queue.pop().data[0], 2);
    EXPECT_EQ(queue.front()->data[0], 1);
}

TEST(TransmitQueueOrder, BootUpMessageDropsEarlierFramesAndIsNotOvertaken) {
    verifies<req::CO_FRAME_003, req::CO_NMT_001>();
    TransmitQueue queue;
    queue.push(numbered(0x583, 1));
    queue.push_boot_up(numbered(0x703, 2));
    queue.push(numbered(0x083, 3));
    queue.push(numbered(0x183, 4));
    for (const int expected : {2, 3, 4}) {
        EXPECT_EQ(queue.pop().data[0], expected);
    }
    EXPECT_TRUE(queue.empty());
}

TEST(TransmitQueueOrder, FramesBehindAWaitingBootUpMessageAreInTheOrderOfTheirPriority) {
    verifies<req::CO_FRAME_002, req::CO_FRAME_003>();
    TransmitQueue queue;
    queue.push_boot_up(numbered(0x703, 1));
    queue.push(numbered(0x583, 4));
    queue.push(numbered(0x183, 3));
    queue.push(numbered(0x083, 2));
    queue.push(numbered(0x703, 5));
    for (const int expected : {1, 2, 3, 4, 5}) {
        EXPECT_EQ(queue.pop().data[0], expected);
    }
}

TEST(TransmitQueueOrder, SecondBootUpMessageReplacesAWaitingOneAndTheFramesBehindIt) {
    verifies<req::CO_FRAME_003, req::CO_NMT_001>();
    TransmitQueue queue;
    queue.push_boot_up(numbered(0x703, 1));
    queue.push(numbered(0x7E4, 2));
    queue.push_boot_up(numbered(0x703, 3));
    EXPECT_EQ(queue.pop().data[0], 3);
    EXPECT_TRUE(queue.empty());
}

TEST(TransmitQueueOrder, QueueIsBoundedAndRefusesFramesWhileClosed) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {
        EXPECT_TRUE(queue.push(numbered(0x100, 0)));
    }
    EXPECT_FALSE(queue.push(numbered(0x100, 0)));
    queue.close();
    EXPECT_TRUE(queue.empty());
    EXPECT_FALSE(queue.push(numbered(0x100, 0)));
    queue.open();
    EXPECT_TRUE(queue.push(numbered(0x100, 0)));
}

TEST(TransmitQueueOrder, SdoSegmentIsQueuedUnlessTheQueueIsFullOrClosed) {
    shows_rule("push_segment() queues eight bytes as push() does, and returns whether it did");
    TransmitQueue queue;
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {
        EXPECT_TRUE(queue.push_segment(0x583, 0x8877665544332201U));
    }
    EXPECT_FALSE(queue.push_segment(0x583, 0));
    const Frame sent = queue.pop();
    EXPECT_EQ(sent.id, 0x583U);
    EXPECT_EQ(sent.length, 8U);
    EXPECT_EQ(read_u32(sent.payload(), 0), 0x44332201U);  // the lowest byte is sent first
    EXPECT_EQ(read_u32(sent.payload(), 4), 0x88776655U);
    queue.close();
    EXPECT_FALSE(queue.push_segment(0x583, 0));
    EXPECT_TRUE(queue.empty());
}

TEST(TransmitQueueOrder, DataFrameQueuedInThePlaceOfAnEarlierRemoteFrameStaysADataFrame) {
    shows_rule("a place of the queue keeps nothing of an earlier frame");
    TransmitQueue queue;
    Frame other = data_frame(0x80, 0);
    other.extended = true;
    other.remote = true;
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {  // afterwards, each place of the queue has contained
                                                                 // this frame
        ASSERT_TRUE(queue.push(other));
        queue.pop();
    }
    ASSERT_TRUE(queue.push(0x583, 8, 0x88));
    ASSERT_TRUE(queue.push_segment(0x583, 0x99));
    for (const int expected : {0x88, 0x99}) {
        const Frame sent = queue.pop();
        EXPECT_FALSE(sent.extended);
        EXPECT_FALSE(sent.remote);
        EXPECT_EQ(sent.length, 8U);
        EXPECT_EQ(sent.data[0], expected);
    }
}

TEST(TransmitQueueOrder, FrameThatIsPutBackPrecedesOtherFramesOfItsIdentifier) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    for (const auto& [id, number] : {std::pair{0x083U, 1}, {0x583U, 2}, {0x583U, 3}, {0x703U, 4}}) {
        ASSERT_TRUE(queue.push(numbered(id, static_cast<std::uint8_t>(number))));
    }
    ASSERT_TRUE(queue.put_back(numbered(0x583, 5)));
    ASSERT_TRUE(queue.put_back(numbered(0x000, 6)));
    for (const int expected : {6, 1, 5, 2, 3, 4}) {
        EXPECT_EQ(queue.pop().data[0], expected);
    }
}

TEST(TransmitQueueOrder, FrameThatIsPutBackIsRefusedByAFullQueueAndLostInAClosedQueue) {
    verifies<req::CO_FRAME_002>();
    TransmitQueue queue;
    for (std::size_t i = 0; i < TransmitQueue::capacity; ++i) {
        ASSERT_TRUE(queue.push(numbered(0x100, 0)));
    }
    EXPECT_FALSE(queue.put_back(numbered(0x083, 1)));
    EXPECT_EQ(queue.pop().id, 0x100U);
    EXPECT_TRUE(queue.put_back(numbered(0x083, 1)));
    EXPECT_EQ(queue.front()->id, 0x083U);
    queue.close();
    EXPECT_TRUE(queue.put_back(numbered(0x083, 1)));
    queue.open();
    EXPECT_TRUE(queue.empty());
}

TEST(TransmitQueueOrder, QueueReportsAWaitingBootUpMessageUntilItIsSentOrDropped) {
    verifies<req::CO_FRAME_003, req::CO_NMT_001>();
    TransmitQueue queue;
    queue.push(numbered(0x083, 1));
    EXPECT_FALSE(queue.boot_up_waits());
    queue.push_boot_up(numbered(0x703, 2));
    EXPECT_TRUE(queue.boot_up_waits());
    ASSERT_TRUE(queue.put_back(numbered(0x083, 3)));  // the frame that was put back stays behind the boot-up message
    EXPECT_EQ(queue.pop().data[0], 2);
    EXPECT_FALSE(queue.boot_up_waits());
    queue.push_boot_up(numbered(0x703, 4));
    queue.close();
    EXPECT_FALSE(queue.boot_up_waits());
}

TEST(Crc, Crc32OfTheDigits1To9IsThePublishedCheckValue) {
    verifies<req::CO_STORE_004>();
    // CRC-32/ISO-HDLC has a published check value: its CRC of the text "123456789".
    const std::array<std::uint8_t, 9> digits{0x31, 0x32, 0x33, 0x34, 0x35, 0x36, 0x37, 0x38, 0x39};
    Crc32 crc;
    crc.add(ByteView{digits});
    EXPECT_EQ(crc.value(), 0xCBF43926U);
}

}  // namespace canproof::test
