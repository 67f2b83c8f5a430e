// SPDX-License-Identifier: Apache-2.0
// The CAN driver of the Zynq UltraScale+, with a model of the controller's registers.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/can_port.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "target/zynqmp/can.hpp"
#include "tests/support/verifies.hpp"
#include "tests/support/zynqmp/zynq_can_model.hpp"

namespace canproof::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The CAN drivers of the STM32F405 and of the Zynq offer the functions that the main loop of a device calls.
static_assert(target::is_can_port<stm32f405::Bxcan> && target::is_can_port<zynqmp::Can>);

constexpr std::uint32_t clock_hz = 24000000;

struct ZynqBench {
    ZynqCanModel model;
    zynqmp::Can can{model.registers(), clock_hz};
    TransmitQueue queue;

    /// Advances the driver by four steps of 1 ms until it is on the bus: reset, filters, joining, on the bus.
    void join(std::uint32_t bit_rate, Instant from = {}) {
        can.set_bit_rate(bit_rate, from);
        for (std::uint64_t step = 1; step <= 4; ++step) {
            can.advance(queue, from + milliseconds(step));
        }
    }
    std::vector<std::uint32_t> received() {
        std::vector<std::uint32_t> ids;
        Frame frame;
        while (can.receive(frame)) {
            ids.push_back(frame.id);
        }
        return ids;
    }
    std::vector<std::uint32_t> sent() {
        std::vector<std::uint32_t> ids;
        can.advance(queue, milliseconds_later());
        while (const auto frame = model.transmit()) {
            ids.push_back(frame->id);
            can.advance(queue, milliseconds_later());
        }
        return ids;
    }
    Instant milliseconds_later() {
        now = now + milliseconds(1);
        return now;
    }
    Instant now{10000};
};

}  // namespace

// The bit rates of CiA 305, Table 1, from a clock of 24 MHz. 24 MHz / bit rate is the quanta per bit times the
// prescaler: 24 × 1 for 1 Mbit/s, 24 × 100 for 10 kbit/s.
TEST(ZynqBitTiming, EveryBitRateOfLssIsExactInTheRegisters) {
    verifies<req::CO_ZCAN_001, req::CO_ZCAN_010>();
    struct Row {
        std::uint32_t rate, clocks;
    };
    for (const Row row : {Row{1000000, 24}, Row{800000, 30}, Row{500000, 48}, Row{250000, 96}, Row{125000, 192},
                          Row{50000, 480}, Row{20000, 1200}, Row{10000, 2400}}) {
        ZynqBench bench;
        bench.join(row.rate);
        EXPECT_TRUE(bench.can.is_on_bus());
        EXPECT_EQ(bench.can.bit_rate(), row.rate);
        const std::uint32_t before = 1 + (bench.model.bit_timing() & 0xFU);
        const std::uint32_t after = 1 + (bench.model.bit_timing() >> 4U & 0x7U);
        const std::uint32_t jump = 1 + (bench.model.bit_timing() >> 7U & 0x3U);
        EXPECT_EQ((bench.model.prescaler() + 1) * (1 + before + after), row.clocks) << row.rate;
        EXPECT_EQ(zynqmp::clocks_of_bit(bench.model.prescaler(), bench.model.bit_timing()), row.clocks);
        EXPECT_GE((1 + before) * 100, 75 * (1 + before + after)) << row.rate;
        EXPECT_LE((1 + before) * 100, 90 * (1 + before + after)) << row.rate;
        EXPECT_LE(jump, after);
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

// 666.667 kbit/s (36 clocks) is a rate of the AX130751. The CAN-CBX-AO412 has 166 kbit/s; the nearest rate from 24 MHz
// is 166.667 kbit/s (144 clocks), 0.4 % too fast.
TEST(ZynqBitTiming, BitRatesThatOnlyDeviceManualsNameAreReachedWithin0Point41Percent) {
    verifies<req::CO_ZCAN_001, req::CO_ZCAN_010>();
    for (const std::uint32_t rate : {666667U, 166000U}) {
        const auto found = zynqmp::bit_timing(clock_hz, rate);
        ASSERT_TRUE(found.ok());
        EXPECT_NEAR(24e6 / found.value().clocks(), rate, 0.0041 * rate);
        const std::uint32_t before = 1 + found.value().before_sample;
        EXPECT_GE(before * 100, 75 * found.value().quanta());
        EXPECT_LE(before * 100, 90 * found.value().quanta());
    }
}

// At 3 kbit/s, a bit has 8000 clocks: 25 quanta with a prescaler of 320. The prescaler register of the Zynq (BRPR)
// cannot have this value; that of bxCAN can.
TEST(ZynqBitTiming, BitRateThatNeedsATooLargePrescalerKeepsTheNodeOffTheBus) {
    verifies<req::CO_ZCAN_002>();
    EXPECT_FALSE(zynqmp::bit_timing(clock_hz, 3000).ok());
    EXPECT_TRUE(stm32f405::bit_timing(clock_hz, 3000).ok());
    for (const std::uint32_t rate : {0U, 3000U, 1700000U}) {
        ZynqBench bench;
        bench.join(500000);
        ASSERT_TRUE(bench.can.is_on_bus());
        bench.join(rate, Instant{20000});
        EXPECT_FALSE(bench.can.is_on_bus());
        EXPECT_EQ(bench.can.state(), CanState::bus_off);
        EXPECT_EQ(bench.model.receive(data_frame(0x80, 0)), ZynqCanModel::Taken::filtered);
        bench.can.advance(bench.queue, Instant{9000000});
        EXPECT_EQ(bench.model.resets(), 2U);  // the controller is not reset again
        bench.join(250000, Instant{9000000});
        EXPECT_TRUE(bench.can.is_on_bus());
        EXPECT_EQ(bench.can.state(), CanState::error_active);
    }
}

TEST(ZynqCan, NewBitRateDropsTheFrameInTheController) {
    verifies<req::CO_ZCAN_003>();
    ZynqBench bench;
    bench.join(125000);
    bench.queue.push(data_frame(0x185, 2));
    bench.queue.push(data_frame(0x285, 2));
    bench.can.advance(bench.queue, Instant{6000});
    ASSERT_TRUE(bench.model.begin_transmission());  // 185h is on the bus
    bench.join(500000, Instant{7000});
    EXPECT_THAT(bench.sent(), ElementsAre(0x285U));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

// Each call of advance() does what the hardware allows at that moment and never waits for the hardware.
TEST(ZynqCan, DriverServesASlowControllerWithoutWaitingForIt) {
    verifies<req::CO_ZCAN_005>();
    ZynqBench bench;
    bench.model.answer_reset(false);
    bench.model.keep_filters_busy(true);
    bench.model.hold_dominant(true);
    // an earlier program has left the filters on; switching them off makes them busy
    bench.model.registers().filters_used.write(1U);
    bench.can.set_bit_rate(125000, Instant{});
    for (std::uint64_t us = 1000; us <= 900000; us += 100000) {
        bench.can.advance(bench.queue, Instant{us});
        EXPECT_EQ(bench.model.resets(), 1U);
    }
    bench.model.answer_reset(true);
    bench.can.advance(bench.queue, Instant{910000});  // detects the end of the reset with its next read
    bench.can.advance(bench.queue, Instant{911000});
    bench.can.advance(bench.queue, Instant{912000});
    EXPECT_FALSE(bench.can.is_on_bus());
    bench.model.keep_filters_busy(false);
    bench.can.advance(bench.queue, Instant{913000});
    bench.can.advance(bench.queue, Instant{914000});
    EXPECT_FALSE(bench.can.is_on_bus());
    bench.model.hold_dominant(false);
    bench.can.advance(bench.queue, Instant{915000});
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(ZynqCan, ControllerThatDoesNotAnswerIsResetAfterOneSecond) {
    verifies<req::CO_ZCAN_004, req::CO_ZCAN_011>();
    ZynqBench bench;
    bench.model.answer_reset(false);
    bench.can.set_bit_rate(125000, Instant{});
    bench.can.advance(bench.queue, Instant{999999});
    EXPECT_EQ(bench.model.resets(), 1U);
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    bench.can.advance(bench.queue, Instant{1000000});
    EXPECT_EQ(bench.model.resets(), 2U);
    EXPECT_EQ(bench.can.state(), CanState::bus_off);
    bench.model.answer_reset(true);
    for (std::uint64_t us = 1001000; us <= 1005000; us += 1000) {
        bench.can.advance(bench.queue, Instant{us});
    }
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    EXPECT_EQ(bench.model.resets(), 2U);
}

TEST(ZynqCan, ControllerWhoseFiltersStayBusyIsResetAfterOneSecond) {
    verifies<req::CO_ZCAN_004, req::CO_ZCAN_011>();
    ZynqBench bench;
    bench.model.keep_filters_busy(true);
    bench.model.registers().filters_used.write(1U);  // an earlier program has left a filter on
    bench.can.set_bit_rate(125000, Instant{});
    bench.can.advance(bench.queue, Instant{1000});  // the reset ends
    bench.can.advance(bench.queue, Instant{2000});  // switches the filter off, which makes it busy
    bench.can.advance(bench.queue, Instant{1001999});
    EXPECT_EQ(bench.model.resets(), 1U);
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    bench.can.advance(bench.queue, Instant{1002000});
    EXPECT_EQ(bench.model.resets(), 2U);
    EXPECT_EQ(bench.can.state(), CanState::bus_off);
    bench.model.keep_filters_busy(false);
    for (std::uint64_t us = 1003000; us <= 1007000; us += 1000) {
        bench.can.advance(bench.queue, Instant{us});
    }
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_EQ(bench.can.state(), CanState::error_active);
}

TEST(ZynqCan, ControllerOnABusThatIsNeverIdleReportsBusOffAndJoinsLater) {
    verifies<req::CO_ZCAN_004, req::CO_ZCAN_011>();
    ZynqBench bench;
    bench.model.hold_dominant(true);
    bench.join(125000);  // from 3 ms on, the driver waits for an idle bus
    bench.can.advance(bench.queue, Instant{1002999});
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    bench.can.advance(bench.queue, Instant{1003000});
    EXPECT_EQ(bench.can.state(), CanState::bus_off);
    EXPECT_EQ(bench.model.resets(), 1U);
    bench.model.hold_dominant(false);
    bench.can.advance(bench.queue, Instant{5000000});
    EXPECT_TRUE(bench.can.is_on_bus());
    EXPECT_EQ(bench.can.state(), CanState::error_active);
}

TEST(ZynqCan, FrameIsReceivedUnchanged) {
    verifies<req::CO_ZCAN_006>();
    ZynqBench bench;
    bench.join(1000000);
    Frame data = data_frame(0x603, 8);
    data.data = {0x40, 0x00, 0x10, 0x01, 0xA5, 0x5A, 0xFF, 0x02};
    Frame remote = data_frame(0x703, 1);
    remote.remote = true;
    for (const Frame& frame : {data, remote, data_frame(0, 2), data_frame(0x7FF, 0)}) {
        ASSERT_EQ(bench.model.receive(frame), ZynqCanModel::Taken::kept);
        Frame got;
        ASSERT_TRUE(bench.can.receive(got));
        EXPECT_EQ(got.id, frame.id);
        EXPECT_EQ(got.length, frame.length);
        EXPECT_EQ(got.remote, frame.remote);
        EXPECT_FALSE(got.extended);
        EXPECT_EQ(got.data, frame.data);
        EXPECT_FALSE(bench.can.receive(got));
    }
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(ZynqCan, FrameWithA29BitIdentifierIsFilteredOutAlsoAfterANewBitRate) {
    verifies<req::CO_ZCAN_006>();
    ZynqBench bench;
    Frame extended = data_frame(0x603, 8);
    extended.extended = true;
    for (const std::uint32_t rate : {500000U, 125000U}) {
        bench.join(rate, Instant{rate});
        EXPECT_EQ(bench.model.receive(extended), ZynqCanModel::Taken::filtered);
        EXPECT_EQ(bench.model.receive(data_frame(0x603, 8)), ZynqCanModel::Taken::kept);
    }
}

TEST(ZynqCan, LengthCodeAboveEightMeansEightBytes) {
    verifies<req::CO_ZCAN_006>();
    ZynqBench bench;
    bench.join(500000);
    bench.model.receive(data_frame(0x203, 15));
    Frame got;
    ASSERT_TRUE(bench.can.receive(got));
    EXPECT_EQ(got.length, 8U);
}

TEST(ZynqCan, ReportedStateIsTheMostSevereStateOfTheController) {
    verifies<req::CO_ZCAN_007>();
    ZynqBench bench;
    bench.join(500000);
    const auto state_at = [&bench](std::uint32_t transmit, std::uint32_t receive) {
        bench.model.count_errors(transmit, receive);
        bench.can.advance(bench.queue, bench.milliseconds_later());
        return bench.can.state();
    };
    EXPECT_EQ(state_at(95, 95), CanState::error_active);
    EXPECT_EQ(state_at(96, 0), CanState::warning);
    EXPECT_EQ(state_at(0, 127), CanState::warning);
    EXPECT_EQ(state_at(0, 128), CanState::error_passive);
    EXPECT_EQ(state_at(256, 0), CanState::bus_off);
    bench.model.pass_recessive(127);
    bench.can.advance(bench.queue, bench.milliseconds_later());
    EXPECT_EQ(bench.can.state(), CanState::bus_off);
    bench.model.pass_recessive(1);
    bench.can.advance(bench.queue, bench.milliseconds_later());
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    EXPECT_EQ(bench.model.resets(), 1U);
}

// 128 times 11 bits take 140.8 ms at 10 kbit/s; with the 100 ms of the STM32F405's driver this is less than 250 ms.
TEST(ZynqCan, BitRateOfABusOffControllerIsUsedAfter250Milliseconds) {
    verifies<req::CO_ZCAN_013>();
    ZynqBench bench;
    bench.join(500000);
    bench.queue.push(data_frame(0x185, 1));
    bench.can.advance(bench.queue, Instant{6000});
    bench.model.count_errors(256, 0);  // the driver has not seen bus-off yet
    bench.can.set_bit_rate(125000, Instant{10000});
    for (std::uint64_t us = 11000; us <= 259000; us += 1000) {
        bench.can.advance(bench.queue, Instant{us});
        bench.model.pass_recessive(128);
        ASSERT_FALSE(bench.can.is_on_bus());
        ASSERT_EQ(bench.can.state(), CanState::bus_off);
        ASSERT_FALSE(bench.model.begin_transmission());
    }
    bench.can.set_bit_rate(250000, Instant{259500});  // a second bit rate does not change the pause
    for (const std::uint64_t us : {259600ULL, 259700ULL, 259800ULL, 260000ULL, 261000ULL}) {
        bench.can.advance(bench.queue, Instant{us});
        EXPECT_EQ(bench.can.is_on_bus(), us == 261000ULL);
    }
    EXPECT_EQ(bench.can.state(), CanState::error_active);
    EXPECT_EQ(zynqmp::clocks_of_bit(bench.model.prescaler(), bench.model.bit_timing()), 96U);  // 24 MHz / 250 kHz
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(ZynqCan, ControllerGetsOneFrameAtATimeWithTheLowestIdentifierFirst) {
    verifies<req::CO_ZCAN_008>();
    ZynqBench bench;
    bench.join(500000);
    bench.queue.push(data_frame(0x585, 8));
    bench.can.advance(bench.queue, Instant{6000});
    EXPECT_TRUE(bench.queue.empty());
    for (const std::uint32_t id : {0x705U, 0x185U, 0x085U}) {
        bench.queue.push(data_frame(id, 1));
    }
    bench.can.advance(bench.queue, Instant{7000});
    EXPECT_EQ(bench.queue.size(), 3U);
    EXPECT_THAT(bench.sent(), ElementsAre(0x585U, 0x085U, 0x185U, 0x705U));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(ZynqCan, FrameIsSentUnchanged) {
    verifies<req::CO_ZCAN_008>();
    ZynqBench bench;
    bench.join(500000);
    Frame data = data_frame(0x185, 7);
    data.data = {1, 2, 3, 4, 5, 6, 7, 0};
    Frame remote = data_frame(0x705, 1);
    remote.remote = true;
    Frame extended = data_frame(0x1ABCDE05, 3);
    extended.extended = true;
    extended.remote = true;
    for (const Frame& frame : {data, remote, extended}) {
        bench.queue.push(frame);
        bench.can.advance(bench.queue, bench.milliseconds_later());
        const auto sent = bench.model.transmit();
        ASSERT_TRUE(sent.has_value());
        EXPECT_EQ(sent->id, frame.id);
        EXPECT_EQ(sent->length, frame.length);
        EXPECT_EQ(sent->remote, frame.remote);
        EXPECT_EQ(sent->extended, frame.extended);
        EXPECT_EQ(sent->data, frame.data);
    }
}

TEST(ZynqCan, FrameWaitsUntilTheControllerHasJoinedTheBus) {
    verifies<req::CO_ZCAN_008>();
    ZynqBench bench;
    bench.model.hold_dominant(true);
    bench.queue.push(data_frame(0x185, 1));
    bench.join(500000);
    EXPECT_EQ(bench.queue.size(), 1U);
    bench.model.hold_dominant(false);
    EXPECT_THAT(bench.sent(), ElementsAre(0x185U));
}

TEST(ZynqCan, FramesKeepTheOrderOfTheBus) {
    verifies<req::CO_ZCAN_009>();
    ZynqBench bench;
    bench.join(500000);
    for (const std::uint32_t id : {0x203U, 0x603U, 0x080U, 0x7E5U, 0x000U}) {
        ASSERT_EQ(bench.model.receive(data_frame(id, 0)), ZynqCanModel::Taken::kept);
    }
    EXPECT_THAT(bench.received(), ElementsAre(0x203U, 0x603U, 0x080U, 0x7E5U, 0x000U));
    EXPECT_FALSE(bench.can.take_overrun());
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

// UG1085: RXFIFO stores 64 frames.
TEST(ZynqCan, FullFifoKeepsItsFramesAndReportsTheLossOnce) {
    verifies<req::CO_ZCAN_012>();
    ZynqBench bench;
    bench.join(500000);
    for (std::uint32_t i = 0; i < 64; ++i) {
        ASSERT_EQ(bench.model.receive(data_frame(0x200 + i, 0)), ZynqCanModel::Taken::kept);
    }
    EXPECT_FALSE(bench.can.take_overrun());
    ASSERT_EQ(bench.model.receive(data_frame(0x100, 0)), ZynqCanModel::Taken::lost);
    EXPECT_TRUE(bench.can.take_overrun());
    EXPECT_FALSE(bench.can.take_overrun());
    const auto ids = bench.received();
    ASSERT_EQ(ids.size(), 64U);
    EXPECT_EQ(ids.front(), 0x200U);
    EXPECT_EQ(ids.back(), 0x23FU);
}

}  // namespace canproof::test
