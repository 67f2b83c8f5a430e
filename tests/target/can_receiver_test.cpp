// SPDX-License-Identifier: Apache-2.0
// Tests the reception of frames from the two FIFOs of the CAN controller, with a model of its registers.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::ElementsAre;
using testing::IsEmpty;

struct Bench {
    BxcanModel model;
    Bxcan can{model.registers(), 42000000};
    TransmitQueue queue;

    Bench() {
        can.set_bit_rate(1000000, Instant{});
        can.advance(queue, Instant{1000});
        can.advance(queue, Instant{2000});
        EXPECT_TRUE(can.is_on_bus());
    }
    std::vector<std::uint32_t> received() {
        std::vector<std::uint32_t> ids;
        Frame frame;
        while (can.receive(frame)) {
            ids.push_back(frame.id);
        }
        return ids;
    }
};

}  // namespace

TEST(CanReceiver, FrameIsReceivedUnchanged) {
    verifies<req::CO_CAN_003>();
    Bench bench;
    Frame sent = data_frame(0x603, 8);
    sent.data = {0x40, 0x00, 0x10, 0x00, 0xA5, 0x5A, 0xFF, 0x01};
    bench.model.receive(sent);
    Frame remote = data_frame(0x703, 1);
    remote.remote = true;
    bench.model.receive(remote);
    bench.can.drain();
    Frame got;
    ASSERT_TRUE(bench.can.receive(got));
    EXPECT_EQ(got.id, 0x603U);
    EXPECT_EQ(got.length, 8U);
    EXPECT_FALSE(got.remote || got.extended);
    EXPECT_EQ(got.data, sent.data);
    ASSERT_TRUE(bench.can.receive(got));
    EXPECT_EQ(got.id, 0x703U);
    EXPECT_TRUE(got.remote);
    EXPECT_FALSE(bench.can.receive(got));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanReceiver, LengthAndKindOfEachFrameAreRead) {
    verifies<req::CO_CAN_003>();
    for (const std::uint32_t length : {0U, 1U, 4U, 7U, 8U}) {
        Bench bench;
        bench.model.receive(data_frame(0x7FF, static_cast<std::uint8_t>(length)));
        bench.can.drain();
        Frame got;
        ASSERT_TRUE(bench.can.receive(got));
        EXPECT_EQ(got.id, 0x7FFU);
        EXPECT_EQ(got.length, length);
        EXPECT_FALSE(got.remote || got.extended);
    }
}

/// The filters of the driver refuse such a frame. If one came all the same, the node must know it by its kind.
TEST(CanReceiver, FrameWith29BitIdentifierBehindOpenFiltersIsReadAsSuch) {
    verifies<req::CO_CAN_003>();
    Bench bench;
    auto& registers = bench.model.registers();
    registers.filter_master.write(1);
    registers.filter_bank[0].mask.write(0);  // passes every identifier
    registers.filter_master.write(0);
    Frame frame = data_frame(0x1ABCDEF5, 3);
    frame.extended = true;
    ASSERT_EQ(bench.model.receive(frame), BxcanModel::Taken::kept);
    bench.can.drain();
    Frame got;
    ASSERT_TRUE(bench.can.receive(got));
    EXPECT_TRUE(got.extended);
    EXPECT_EQ(got.id, 0x1ABCDEF5U);
    EXPECT_EQ(got.length, 3U);
}

TEST(CanReceiver, LengthCodeAboveEightMeansEightBytes) {
    verifies<req::CO_CAN_003>();
    Bench bench;
    bench.model.receive(data_frame(0x203, 15));
    bench.can.drain();
    Frame got;
    ASSERT_TRUE(bench.can.receive(got));
    EXPECT_EQ(got.length, 8U);
}

TEST(CanReceiver, FramesOfBothFifosKeepTheOrderOfTheBus) {
    verifies<req::CO_CAN_004>();
    Bench bench;
    // The time stamps of the model wrap at 65,536 within the first hundred bit times.
    for (const std::uint32_t id : {0x203U, 0x603U, 0x080U, 0x7E5U, 0x603U, 0x000U}) {
        ASSERT_EQ(bench.model.receive(data_frame(id, 0)), BxcanModel::Taken::kept);
    }
    bench.can.drain();
    EXPECT_THAT(bench.received(), ElementsAre(0x203, 0x603, 0x080, 0x7E5, 0x603, 0x000));
    EXPECT_FALSE(bench.can.take_overrun());
}

TEST(CanReceiver, FullFifoKeepsTheOldFramesAndReportsTheLoss) {
    verifies<req::CO_CAN_005>();
    for (const std::uint32_t base : {0x200U, 0x600U}) {
        Bench bench;
        for (std::uint32_t i = 0; i < fifo_depth; ++i) {
            ASSERT_EQ(bench.model.receive(data_frame(base + i, 0)), BxcanModel::Taken::kept);
        }
        ASSERT_EQ(bench.model.receive(data_frame(base + 3, 0)), BxcanModel::Taken::lost);
        bench.can.drain();
        EXPECT_THAT(bench.received(), ElementsAre(base, base + 1, base + 2));
        EXPECT_TRUE(bench.can.take_overrun());
        EXPECT_FALSE(bench.can.take_overrun());
        bench.model.receive(data_frame(base + 4, 0));
        bench.can.drain();
        EXPECT_THAT(bench.received(), ElementsAre(base + 4));
        EXPECT_FALSE(bench.can.take_overrun());
    }
}

TEST(CanReceiver, ControllerModelOverwritesTheLastFrameWithoutTheFifoLock) {
    verifies<req::CO_CAN_005>();
    Bench bench;
    auto& registers = bench.model.registers();
    registers.master_control.write(mcr::time_stamps);  // clears the FIFO lock (RFLM) that the driver has set
    for (std::uint32_t i = 0; i < 4; ++i) {
        bench.model.receive(data_frame(0x200 + i, 0));
    }
    bench.can.drain();
    EXPECT_THAT(bench.received(), ElementsAre(0x200, 0x201, 0x203));
    EXPECT_TRUE(bench.can.take_overrun());
}

TEST(CanReceiver, SlowlyReleasedFifoSlotIsNotReadTwice) {
    verifies<req::CO_CAN_004>();
    Bench bench;
    bench.model.release_slowly(true);
    bench.model.receive(data_frame(0x203, 0));
    bench.model.receive(data_frame(0x603, 0));
    bench.can.drain();
    EXPECT_THAT(bench.received(), ElementsAre(0x203));
    bench.model.finish_release();
    bench.can.drain();
    EXPECT_THAT(bench.received(), ElementsAre(0x603));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanReceiver, FullReceiveRingBufferReportsTheLossAndKeepsItsFrames) {
    verifies<req::CO_CAN_005>();
    Bench bench;
    for (std::uint32_t i = 0; i < ReceiveRing::capacity; ++i) {
        bench.model.receive(data_frame(i, 0));
        bench.can.drain();
    }
    EXPECT_FALSE(bench.can.take_overrun());
    bench.model.receive(data_frame(0x7FF, 0));
    bench.can.drain();
    EXPECT_TRUE(bench.can.take_overrun());
    const auto ids = bench.received();
    ASSERT_EQ(ids.size(), ReceiveRing::capacity);
    EXPECT_EQ(ids.back(), ReceiveRing::capacity - 1);
}

TEST(CanReceiver, InterruptsAreEnabledForBothFifosOnly) {
    verifies<req::CO_CAN_004>();
    Bench bench;
    bench.can.interrupt_on_frames(true);
    EXPECT_EQ(bench.model.interrupts(), 0x12U);  // the interrupts FMPIE0 and FMPIE1 (frame pending), bits 1 and 4
    bench.can.interrupt_on_frames(false);
    EXPECT_EQ(bench.model.interrupts(), 0U);
}

}  // namespace canproof::test
