// SPDX-License-Identifier: Apache-2.0
// The exact writes of the Zynq UltraScale+'s CAN driver to the registers of the controller, with values that are
// written out from UG1087.
#include <gmock/gmock.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "target/zynqmp/can.hpp"
#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/verifies.hpp"
#include "tests/support/zynqmp/zynq_can_model.hpp"

namespace canproof::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uintptr_t can1_at = 0xFF070000;  // UG1087: module CAN1

/// The driver with a model of CAN1 at its address.
struct ZynqAtItsAddress {
    ZynqCanModel model;
    Window at_can{can1_at, model.registers()};
    AccessLog log;
    zynqmp::Can can{stm32f405::registers_at<zynqmp::CanRegisters>(can1_at), 24000000};
    TransmitQueue queue;

    void join() {
        can.set_bit_rate(500000, Instant{});
        for (std::uint64_t us = 1000; us <= 4000; us += 1000) {
            can.advance(queue, Instant{us});
        }
    }
    /// Sends a frame of three bytes. Returns the words that the driver writes.
    std::vector<Write> sent(std::uint32_t id, bool extended, bool remote) {
        Frame frame = data_frame(id, 3);
        frame.data = {0x81, 0x02, 0xFF, 0x04, 0x05, 0x86, 0x07, 0x08};
        frame.extended = extended;
        frame.remote = remote;
        log.take_writes();
        queue.push(frame);
        can.advance(queue, Instant{5000});
        EXPECT_TRUE(model.transmit());
        return log.take_writes();
    }
};

}  // namespace

// UG1087, module CAN1 at FF070000h. SRR: SRST (0). AFR = 0 ends the use of the filters before they are written. At 24
// MHz, 500 kbit/s are 48 clocks: 16 quanta of 3 clocks, 13 before and 2 after the sample point, a jump width of 2. BRPR
// = 3 - 1; BTR: TS1 = 12 from bit 0, TS2 = 1 from bit 4, SJW = 1 from bit 7. AFMR1: IDE (19) is compared with AFIR1 =
// 0, then AFR: UAF1 (0). MSR = 0, the normal mode. SRR: CEN (1), last, because it ends the configuration mode.
TEST(ZynqWrites, JoiningWritesTheRegistersOfTheRegisterReference) {
    verifies<req::CO_ZCAN_001, req::CO_ZCAN_006>();
    ZynqAtItsAddress bench;
    bench.join();
    EXPECT_TRUE(bench.can.is_on_bus());
    auto writes = bench.log.take_writes();
    ASSERT_EQ(writes.size(), 9U);
    const auto by_address = [](const Write& a, const Write& b) { return a.address < b.address; };
    std::sort(writes.begin() + 2, writes.begin() + 6, by_address);  // the hardware permits any order of these
    std::sort(writes.begin() + 6, writes.begin() + 8, by_address);  // and of these
    EXPECT_THAT(writes, ElementsAre(Write{can1_at, 1U}, Write{can1_at + 0x60, 0U}, Write{can1_at + 0x08, 2U},
                                    Write{can1_at + 0x0C, 1U << 7U | 1U << 4U | 12U}, Write{can1_at + 0x64, 1U << 19U},
                                    Write{can1_at + 0x68, 0U}, Write{can1_at + 0x04, 0U}, Write{can1_at + 0x60, 1U},
                                    Write{can1_at, 2U}));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

// UG1085, Table 20-3: IDH (21), SRR/RTR of 11 bits (20), IDE (19), IDL (1), RTR of 29 bits (0). SRR is 1 with 29 bits.
// DLC is in bits 28 to 31. The first byte of a word is in its highest bits.
TEST(ZynqWrites, FrameIsWrittenInTheFourWordsOfTheTransmitBuffer) {
    verifies<req::CO_ZCAN_008>();
    ZynqAtItsAddress bench;
    bench.join();
    const auto words = [](std::uint32_t identifier) {
        return ElementsAre(Write{can1_at + 0x40, identifier}, Write{can1_at + 0x44, 3U << 28U},
                           Write{can1_at + 0x48, 0x8102FF04U}, Write{can1_at + 0x4C, 0x05860708U});
    };
    constexpr std::uint32_t high = 0x1ABCDE05U >> 18U, low = 0x1ABCDE05U & 0x3FFFFU;
    constexpr std::uint32_t long_identifier = high << 21U | 1U << 20U | 1U << 19U | low << 1U;
    EXPECT_THAT(bench.sent(0x185, false, false), words(0x185U << 21U));
    EXPECT_THAT(bench.sent(0x185, false, true), words(0x185U << 21U | 1U << 20U));
    EXPECT_THAT(bench.sent(0x1ABCDE05, true, false), words(long_identifier));
    EXPECT_THAT(bench.sent(0x1ABCDE05, true, true), words(long_identifier | 1U));
}

// ICR clears RXOFLW (6). A write without a lost frame could clear the flag of a frame that is lost at that moment.
TEST(ZynqWrites, OverrunIsClearedOnlyAfterItWasSeen) {
    verifies<req::CO_ZCAN_012>();
    ZynqAtItsAddress bench;
    bench.join();
    bench.log.take_writes();
    EXPECT_FALSE(bench.can.take_overrun());
    EXPECT_THAT(bench.log.take_writes(), IsEmpty());
    for (int i = 0; i < 65; ++i) {
        bench.model.receive(data_frame(0x203, 0));
    }
    EXPECT_TRUE(bench.can.take_overrun());
    EXPECT_THAT(bench.log.take_writes(), ElementsAre(Write{can1_at + 0x24, 1U << 6U}));
}

TEST(ZynqWrites, QueueOf32FramesLeavesInOneCallWhenTheControllerSendsAtOnce) {
    verifies<req::CO_ZCAN_008>();
    ZynqAtItsAddress bench;
    bench.join();
    bench.model.send_at_once(true);
    for (std::uint32_t id = 1; id <= 32; ++id) {
        ASSERT_TRUE(bench.queue.push(data_frame(id, 0)));
    }
    bench.can.advance(bench.queue, Instant{5000});
    EXPECT_TRUE(bench.queue.empty());
    EXPECT_EQ(bench.model.sent_at_once(), 32U);
}

// The filter stops 29-bit identifiers. One that comes all the same keeps its identifier, so that the node can tell that
// it is none of its own.
TEST(ZynqWrites, FrameWithA29BitIdentifierThatPassesTheFilterKeepsItsIdentifier) {
    verifies<req::CO_ZCAN_006>();
    ZynqAtItsAddress bench;
    bench.join();
    bench.model.registers().filters_used.write(0U);  // without a filter, every frame passes
    for (const bool remote : {false, true}) {
        Frame frame = data_frame(0x1ABCDE05, 8);
        frame.data = {0x81, 0xFF, 0x03, 0x85, 0x05, 0xFF, 0xA7, 0x09};
        frame.extended = true;
        frame.remote = remote;
        ASSERT_EQ(bench.model.receive(frame), ZynqCanModel::Taken::kept);
        Frame got;
        ASSERT_TRUE(bench.can.receive(got));
        EXPECT_TRUE(got.extended);
        EXPECT_EQ(got.id, 0x1ABCDE05U);
        EXPECT_EQ(got.remote, remote);
        EXPECT_EQ(got.data, frame.data);
    }
}

TEST(ZynqWrites, NodeStaysOnTheBusForLongerThanTheLongestWaitForAStep) {
    verifies<req::CO_ZCAN_011>();
    ZynqAtItsAddress bench;
    bench.join();
    bench.can.advance(bench.queue, Instant{10000000});
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    EXPECT_EQ(bench.model.resets(), 1U);
}

// The processor restarts while the controller stays bus-off: the driver of the new start must not forget the bus-off.
TEST(ZynqWrites, BusOffOfAnEarlierProgramIsFollowedByThePauseToo) {
    verifies<req::CO_ZCAN_013>();
    ZynqAtItsAddress bench;
    bench.join();
    bench.model.count_errors(256, 0);
    zynqmp::Can restarted{stm32f405::registers_at<zynqmp::CanRegisters>(can1_at), 24000000};
    restarted.set_bit_rate(500000, Instant{});
    EXPECT_EQ(restarted.state(), CanState::bus_off);
    for (std::uint64_t us = 1000; us < 250000; us += 1000) {
        restarted.advance(bench.queue, Instant{us});
        ASSERT_FALSE(restarted.is_on_bus());
    }
    restarted.advance(bench.queue, Instant{250000});
    restarted.advance(bench.queue, Instant{251000});
    EXPECT_TRUE(restarted.is_on_bus());
}

TEST(ZynqWrites, ControllerThatHasRestedAfterABusOffReportsItUntilItHasJoinedTheBus) {
    verifies<req::CO_ZCAN_007, req::CO_ZCAN_013>();
    ZynqAtItsAddress bench;
    bench.join();
    bench.model.count_errors(256, 0);
    bench.can.set_bit_rate(250000, Instant{10000});
    bench.model.hold_dominant(true);
    for (std::uint64_t us = 11000; us <= 300000; us += 1000) {  // from 260 ms on, the driver waits for an idle bus
        bench.can.advance(bench.queue, Instant{us});
        ASSERT_EQ(bench.can.state(), CanState::bus_off) << us;
    }
    bench.model.hold_dominant(false);
    bench.can.advance(bench.queue, Instant{301000});
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_EQ(bench.can.state(), CanState::error_active);
}

// BTR: SJW from bit 7, TS2 from bit 4, TS1 from bit 0, each less one. BRPR has 8 bits: 256 clocks a quantum at most.
TEST(ZynqBitTiming, GreatestValuesFitTheFieldsOfTheRegisters) {
    verifies<req::CO_ZCAN_001, req::CO_ZCAN_002>();
    EXPECT_EQ(zynqmp::segments_register({1, 16, 5, 3}), 2U << 7U | 4U << 4U | 15U);
    EXPECT_EQ(zynqmp::segments_register({1, 16, 8, 4}), 3U << 7U | 7U << 4U | 15U);
    EXPECT_EQ(zynqmp::bit_timing(16 * 256 * 10000, 10000).value().prescaler, 256U);
    EXPECT_FALSE(zynqmp::bit_timing(16 * 257 * 10000, 10000).ok());
}

}  // namespace canproof::test
