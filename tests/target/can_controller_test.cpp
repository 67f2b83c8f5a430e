// SPDX-License-Identifier: Apache-2.0
// Tests how the CAN controller joins and leaves the bus, with a model of its registers.
#include "target/stm32f405/can_controller.hpp"

#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/stm32f405/register_record.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::IsEmpty;

Instant at_ms(std::uint64_t ms) {
    return Instant{ms * 1000};
}

Frame extended_frame(std::uint32_t id) {
    Frame frame = data_frame(id, 8);
    frame.extended = true;
    return frame;
}

struct Bench {
    BxcanModel model;
    CanController controller{model.registers(), 42000000};

    void join() {
        controller.set_bit_rate(1000000, at_ms(0));
        controller.advance(at_ms(1));
        controller.advance(at_ms(2));
        ASSERT_TRUE(controller.is_on_bus());
    }
};

}  // namespace

TEST(CanController, ControllerJoinsTheBusInTwoStepsAtTheSelectedBitRate) {
    verifies<req::CO_CAN_001>();
    Bench bench;
    EXPECT_EQ(bench.controller.bit_rate(), 0U);
    bench.controller.set_bit_rate(500000, at_ms(0));
    EXPECT_FALSE(bench.controller.is_on_bus());
    bench.controller.advance(at_ms(1));
    EXPECT_FALSE(bench.controller.is_on_bus());
    bench.controller.advance(at_ms(2));
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
    EXPECT_EQ(bench.controller.bit_rate(), 500000U);
    // At 500 kbit/s, one bit has 84 clocks. The fields of CAN_BTR contain each value minus one.
    const std::uint32_t bits = bench.model.bit_timing();
    EXPECT_EQ(((bits & 0x3FFU) + 1) * (1 + ((bits >> 16U & 0xFU) + 1) + ((bits >> 20U & 0x7U) + 1)), 84U);
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

// CAN_MSR has the offset 4 (RM0090 32.9.2): a driver that waits for the controller would read it again and again.
TEST(CanController, NoCallWaitsForAControllerThatDoesNotAnswer) {
    verifies<req::CO_CAN_011>();
    constexpr std::size_t at_msr = 0x04;
    Bench bench;
    RegisterRecord record;
    record.watch(bench.model.registers());
    const auto expect_no_wait = [&record](const char* call) {
        EXPECT_LE(record.reads_of(at_msr), 3U) << call;
        EXPECT_LE(record.reads(), 20U) << call;
        record.clear();
    };
    bench.model.answer_initialisation(false);
    bench.controller.set_bit_rate(500000, at_ms(0));
    expect_no_wait("set_bit_rate()");
    for (const std::uint64_t ms : {0U, 1U, 2U, 999U, 1000U, 1500U}) {
        bench.controller.advance(at_ms(ms));
        expect_no_wait("advance() without an answer");
    }
    bench.model.answer_initialisation(true);
    bench.model.hold_dominant(true);
    for (const std::uint64_t ms : {2000U, 2001U, 3001U, 3500U}) {
        bench.controller.advance(at_ms(ms));
        expect_no_wait("advance() on a bus that is held dominant");
    }
}

TEST(CanController, BitRateThatTheClockCannotGiveKeepsTheControllerOffTheBus) {
    verifies<req::CO_CAN_009>();
    Bench bench;
    bench.join();
    bench.controller.set_bit_rate(800000, at_ms(5));
    for (std::uint64_t ms = 6; ms < 5000; ms += 100) {
        bench.controller.advance(at_ms(ms));
        EXPECT_FALSE(bench.controller.is_on_bus());
    }
    EXPECT_TRUE(bench.model.is_initialising());
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    bench.controller.set_bit_rate(250000, at_ms(5000));
    bench.controller.advance(at_ms(5001));
    bench.controller.advance(at_ms(5002));
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
}

TEST(CanController, ControllerThatDoesNotInitialiseWithinASecondIsReset) {
    verifies<req::CO_CAN_002>();
    Bench bench;
    bench.model.answer_initialisation(false);
    bench.controller.set_bit_rate(1000000, at_ms(0));
    bench.controller.advance(at_ms(999));
    EXPECT_EQ(bench.model.resets(), 0U);
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
    bench.controller.advance(at_ms(1000));
    EXPECT_EQ(bench.model.resets(), 1U);
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    bench.controller.advance(at_ms(1999));
    EXPECT_EQ(bench.model.resets(), 1U);
    bench.model.answer_initialisation(true);
    bench.controller.advance(at_ms(2000));
    bench.controller.advance(at_ms(2001));
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
}

TEST(CanController, BusStuckAtDominantIsReportedAsBusOffUntilReleased) {
    verifies<req::CO_CAN_010>();
    Bench bench;
    bench.model.hold_dominant(true);
    bench.controller.set_bit_rate(1000000, at_ms(0));
    bench.controller.advance(at_ms(1));
    bench.controller.advance(at_ms(1000));
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
    bench.controller.advance(at_ms(1001));
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    EXPECT_EQ(bench.model.resets(), 0U);
    for (std::uint64_t ms = 1100; ms < 9000; ms += 100) {
        bench.controller.advance(at_ms(ms));
        ASSERT_EQ(bench.controller.state(), CanState::bus_off) << ms;
    }
    bench.model.hold_dominant(false);
    bench.controller.advance(at_ms(9000));
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
}

TEST(CanController, Every11BitIdentifierIsAcceptedAndNo29BitIdentifier) {
    verifies<req::CO_CAN_003>();
    Bench bench;
    bench.join();
    for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
        const std::size_t fifo = id < 0x400 ? 0 : 1;
        if (bench.model.pending(fifo) == fifo_depth) {
            for (std::size_t i = 0; i < fifo_depth; ++i) {
                bench.model.registers().receive_fifo[fifo].write(rfr::release);
            }
        }
        Frame frame = data_frame(id, 8);
        frame.remote = id % 3 == 0;
        const std::size_t before = bench.model.pending(fifo);
        ASSERT_EQ(bench.model.receive(frame), BxcanModel::Taken::kept) << id;
        ASSERT_EQ(bench.model.pending(fifo), before + 1) << id;
    }
    for (const std::uint32_t id : {0U, 1U, 0x7E5U, 0x1FFFFFFFU, 0x601U << 18U, 0x400U << 18U}) {
        EXPECT_EQ(bench.model.receive(extended_frame(id)), BxcanModel::Taken::filtered) << id;
    }
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanController, MostSevereStateThatTheControllerShowsIsReported) {
    verifies<req::CO_CAN_007>();
    Bench bench;
    bench.join();
    // RM0090 32.9.2, CAN_ESR: an error counter of 96 or more gives error warning, above 127 error passive, above 255
    // bus-off.
    struct Row {
        std::uint32_t transmit, receive;
        CanState state;
    };
    for (const Row& row : {Row{95, 95, CanState::error_active},
                           {96, 0, CanState::warning},
                           {0, 96, CanState::warning},
                           {127, 127, CanState::warning},
                           {128, 0, CanState::error_passive},
                           {0, 128, CanState::error_passive},
                           {255, 0, CanState::error_passive},
                           {0, 0, CanState::error_active},
                           {256, 0, CanState::bus_off}}) {
        bench.model.count_errors(row.transmit, row.receive);
        bench.controller.advance(at_ms(3));
        EXPECT_EQ(bench.controller.state(), row.state) << row.transmit << ' ' << row.receive;
    }
}

TEST(CanController, ControllerRecoversFromBusOffOnlyAfterThePauseOfTheDriver) {
    verifies<req::CO_CAN_008, req::CO_CAN_015>();
    Bench bench;
    bench.join();
    bench.model.count_errors(256, 0);
    bench.controller.advance(at_ms(10));
    bench.model.pass_recessive(1000);  // without automatic recovery (ABOM), recessive bits count only after the
                                       // driver's request
    bench.controller.advance(at_ms(109));
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    bench.controller.advance(at_ms(110));
    EXPECT_FALSE(bench.controller.is_on_bus());
    bench.controller.advance(at_ms(111));
    bench.controller.advance(at_ms(112));
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    bench.model.pass_recessive(127);
    bench.controller.advance(at_ms(5000));  // a repeated request would restart the count, so the controller makes none
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    bench.model.pass_recessive(1);
    bench.controller.advance(at_ms(5001));
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanController, BitRateOfABusOffControllerWaitsForThePause) {
    verifies<req::CO_CAN_008, req::CO_CAN_016>();
    for (const bool is_noticed : {true, false}) {  // whether the driver saw bus-off before it gets the new bit rate
        Bench bench;
        bench.join();
        const std::uint32_t old_timing = bench.model.bit_timing();
        bench.model.count_errors(256, 0);
        if (is_noticed) {
            bench.controller.advance(at_ms(10));
        }
        bench.controller.set_bit_rate(500000, at_ms(10));
        EXPECT_EQ(bench.controller.bit_rate(), 500000U);
        for (const std::uint64_t ms : {10ULL, 11ULL, 50ULL, 109ULL}) {
            bench.controller.advance(at_ms(ms));
            EXPECT_EQ(bench.controller.state(), CanState::bus_off);
            EXPECT_EQ(bench.model.bit_timing(), old_timing);
            bench.model.pass_recessive(1000);  // nothing counts them before the recovery
        }
        for (const std::uint64_t ms : {110ULL, 111ULL, 112ULL}) {
            bench.controller.advance(at_ms(ms));
        }
        EXPECT_NE(bench.model.bit_timing(), old_timing);
        EXPECT_TRUE(bench.controller.is_on_bus());
        bench.model.pass_recessive(127);
        bench.controller.advance(at_ms(5000));  // a second beginning of the recovery would restart the count
        EXPECT_EQ(bench.controller.state(), CanState::bus_off);
        bench.model.pass_recessive(1);
        bench.controller.advance(at_ms(5001));
        EXPECT_EQ(bench.controller.state(), CanState::error_active);
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

TEST(CanController, BitRateDuringTheRecoveryBeginsItOnceMore) {
    verifies<req::CO_CAN_017>();
    Bench bench;
    bench.join();
    bench.model.count_errors(256, 0);
    for (const std::uint64_t ms : {10ULL, 110ULL, 111ULL, 112ULL}) {
        bench.controller.advance(at_ms(ms));
    }
    bench.model.pass_recessive(100);
    bench.controller.set_bit_rate(10000, at_ms(120));
    for (const std::uint64_t ms : {121ULL, 122ULL}) {  // without a second pause
        bench.controller.advance(at_ms(ms));
    }
    EXPECT_TRUE(bench.controller.is_on_bus());
    EXPECT_EQ(bench.controller.state(), CanState::bus_off);
    bench.model.pass_recessive(127);
    for (const std::uint64_t ms : {221ULL, 222ULL, 223ULL, 5000ULL}) {  // 128 times 11 bits take 140.8 ms at 10 kbit/s
        bench.controller.advance(at_ms(ms));
        EXPECT_TRUE(bench.controller.is_on_bus());
    }
    bench.model.pass_recessive(1);
    bench.controller.advance(at_ms(5001));
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
}

TEST(CanController, BitRateThatCannotBeGivenInBusOffLeavesTheBusAtOnce) {
    verifies<req::CO_CAN_009, req::CO_CAN_016>();
    Bench bench;
    bench.join();
    bench.model.count_errors(256, 0);
    bench.controller.advance(at_ms(10));
    bench.controller.set_bit_rate(0, at_ms(20));
    bench.controller.advance(at_ms(200));
    EXPECT_TRUE(bench.model.is_initialising());
    bench.controller.set_bit_rate(1000000, at_ms(1000));
    for (const std::uint64_t ms : {1001ULL, 1002ULL, 1003ULL}) {  // the pause ended at 110 ms
        bench.controller.advance(at_ms(ms));
    }
    EXPECT_TRUE(bench.controller.is_on_bus());
    bench.model.pass_recessive(128);
    bench.controller.advance(at_ms(1100));
    EXPECT_EQ(bench.controller.state(), CanState::error_active);
}

TEST(CanController, SecondBusOffHasItsOwnRecoveryPause) {
    verifies<req::CO_CAN_008, req::CO_CAN_015>();
    Bench bench;
    bench.join();
    for (const std::uint64_t begin : {1000ULL, 2000ULL}) {
        bench.model.count_errors(256, 0);
        bench.controller.advance(at_ms(begin));
        bench.controller.advance(at_ms(begin + 99));
        EXPECT_TRUE(bench.controller.is_on_bus());
        for (const std::uint64_t ms : {100ULL, 101ULL, 102ULL}) {
            bench.controller.advance(at_ms(begin + ms));
        }
        EXPECT_EQ(bench.controller.state(), CanState::bus_off);
        bench.model.pass_recessive(128);
        bench.controller.advance(at_ms(begin + 200));
        EXPECT_EQ(bench.controller.state(), CanState::error_active);
    }
}

TEST(CanRegisters, RegistersHaveTheAddressesOfTheReferenceManual) {
    verifies<req::CO_CAN_001, req::CO_CAN_003, req::CO_CAN_006>();
    BxcanRegisters block{};
    const auto offset = [&block](const Register& one) {
        return reinterpret_cast<const char*>(&one) - reinterpret_cast<const char*>(&block);
    };
    // RM0090 32.9.5
    EXPECT_EQ(offset(block.bit_timing), 0x01C);
    EXPECT_EQ(offset(block.transmit[0].identifier), 0x180);
    EXPECT_EQ(offset(block.transmit[2].data_high), 0x1AC);
    EXPECT_EQ(offset(block.receive[0].identifier), 0x1B0);
    EXPECT_EQ(offset(block.receive[1].data_high), 0x1CC);
    EXPECT_EQ(offset(block.filter_master), 0x200);
    EXPECT_EQ(offset(block.filter_mode), 0x204);
    EXPECT_EQ(offset(block.filter_scale), 0x20C);
    EXPECT_EQ(offset(block.filter_fifo), 0x214);
    EXPECT_EQ(offset(block.filter_active), 0x21C);
    EXPECT_EQ(offset(block.filter_bank[27].mask), 0x31C);
}

}  // namespace canproof::test
