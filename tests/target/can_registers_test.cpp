// SPDX-License-Identifier: Apache-2.0
// Tests what the CAN driver writes to each register, as values of RM0090 32.9, and how often it accesses the registers.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/stm32f405/register_record.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

// Offsets of the registers: RM0090 32.9.5.
constexpr std::size_t at_mcr = 0x000, at_tsr = 0x008, at_rf0r = 0x00C, at_rf1r = 0x010, at_btr = 0x01C, at_ti0r = 0x180,
                      at_ri0r = 0x1B0, at_fmr = 0x200, at_fm1r = 0x204, at_fs1r = 0x20C, at_ffa1r = 0x214,
                      at_fa1r = 0x21C, at_bank_0 = 0x240, at_bank_1 = 0x248;

/// The driver on the model; all its accesses to registers are recorded.
struct RecordedCan {
    BxcanModel model;
    RegisterRecord record;
    Bxcan can{model.registers(), 42000000};
    TransmitQueue queue;
    Instant now{};

    RecordedCan() { record.watch(model.registers()); }

    void serve() {
        now.us += 100;
        can.advance(queue, now);
    }
    void join() {
        can.set_bit_rate(1000000, now);
        serve();
        serve();
        ASSERT_TRUE(can.is_on_bus());
        record.clear();
    }
    void queue_up(std::initializer_list<std::uint32_t> ids) {
        for (const std::uint32_t id : ids) {
            ASSERT_TRUE(queue.push(data_frame(id, 0)));
        }
    }
};

}  // namespace

TEST(CanRegisters, ControllerIsConfiguredWithTheValuesOfTheReferenceManual) {
    verifies<req::CO_CAN_001, req::CO_CAN_003>();
    RecordedCan bench;
    // A second configuration finds the registers as the first one has left them, and must write the same values.
    for (const std::uint32_t bit_rate : {500000U, 1000000U}) {
        bench.record.clear();
        bench.can.set_bit_rate(bit_rate, bench.now);
        // CAN_MCR: TTCM (bit 7), RFLM (bit 3) and INRQ (bit 0). SLEEP, TXFP, NART and ABOM are 0.
        EXPECT_THAT(bench.record.writes(), ElementsAre(Pair(at_mcr, 0x89)));
        bench.record.clear();
        bench.serve();
        RegisterRecord& record = bench.record;
        // CAN_MCR without INRQ comes last: CAN_BTR can be written only in initialisation mode (32.9.2).
        EXPECT_EQ(record.writes().size(), 14U);
        EXPECT_EQ(record.writes().back(), RegisterRecord::One(at_mcr, 0x88));
        EXPECT_EQ(record.writes_to(at_btr).size(), 1U);
        // CAN_FMR: FINIT (bit 0), with the other bits of its value after a reset. The model reports a fault when a
        // filter is written while FINIT is 0.
        EXPECT_THAT(record.writes_to(at_fmr), ElementsAre(0x2A1C0E01, 0x2A1C0E00));
        EXPECT_THAT(record.writes_to(at_fm1r), ElementsAre(0));     // identifier and mask in each bank
        EXPECT_THAT(record.writes_to(at_fs1r), ElementsAre(3));     // 32 bits in banks 0 and 1
        EXPECT_THAT(record.writes_to(at_ffa1r), ElementsAre(2));    // bank 1 fills FIFO 1
        EXPECT_THAT(record.writes_to(at_fa1r), ElementsAre(0, 3));  // banks 0 and 1 are active at the end
        // Bit 10 of an identifier of 11 bits is bit 31 of a bank, IDE is bit 2 (32.7.4). Bank 0 passes 000h to 3FFh,
        // bank 1 passes 400h to 7FFh.
        EXPECT_THAT(record.writes_to(at_bank_0), ElementsAre(0x00000000));
        EXPECT_THAT(record.writes_to(at_bank_0 + 4), ElementsAre(0x80000004));
        EXPECT_THAT(record.writes_to(at_bank_1), ElementsAre(0x80000000));
        EXPECT_THAT(record.writes_to(at_bank_1 + 4), ElementsAre(0x80000004));
        EXPECT_THAT(record.writes_to(at_tsr), ElementsAre(0x00808080));  // ABRQ0, ABRQ1, ABRQ2: bits 7, 15, 23
        EXPECT_THAT(bench.model.faults(), IsEmpty());
        bench.serve();
        EXPECT_TRUE(bench.can.is_on_bus());
    }
}

TEST(CanRegisters, FrameIsWrittenToItsMailboxBeforeItsRequest) {
    verifies<req::CO_CAN_006>();
    RecordedCan bench;
    bench.join();
    Frame data = data_frame(0x583, 8);
    data.data = {0x43, 0x00, 0x10, 0x00, 0x91, 0x01, 0x08, 0xFF};
    Frame remote = data_frame(0x702, 1);
    remote.remote = true;
    Frame extended = data_frame(0x1ABCDEF5, 0);
    extended.extended = true;
    for (const Frame& frame : {data, remote, extended}) {
        ASSERT_TRUE(bench.queue.push(frame));
    }
    bench.serve();
    struct Row {
        std::uint32_t identifier, length, low, high;
    };
    // CAN_TIxR: STID in bits 31 to 21, or EXID in bits 31 to 3 with IDE (bit 2); RTR is bit 1.
    const std::array<Row, 3> rows{Row{0x583U << 21U, 8, 0x00100043, 0xFF080191},
                                  {(0x702U << 21U) | 2U, 1, 0, 0},
                                  {(0x1ABCDEF5U << 3U) | 4U, 0, 0, 0}};
    const auto writes = bench.record.writes();
    ASSERT_EQ(writes.size(), 15U);  // five for each mailbox
    for (std::size_t mailbox = 0; mailbox < rows.size(); ++mailbox) {
        const Row& row = rows[mailbox];
        const std::size_t at = at_ti0r + 16 * mailbox;
        EXPECT_THAT(bench.record.writes_to(at + 4), ElementsAre(row.length));
        EXPECT_THAT(bench.record.writes_to(at + 8), ElementsAre(row.low));
        EXPECT_THAT(bench.record.writes_to(at + 12), ElementsAre(row.high));
        // TXRQ (bit 0) comes last: from then on the mailbox must not be written (32.7.1).
        EXPECT_THAT(bench.record.writes_to(at), ElementsAre(row.identifier, row.identifier | 1U));
        EXPECT_EQ(writes[5 * mailbox + 4], std::pair(at, row.identifier | 1U));
    }
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanRegisters, FlagsOfASentFrameAreClearedInItsMailboxOnly) {
    verifies<req::CO_CAN_006>();
    RecordedCan bench;
    bench.join();
    bench.queue_up({0x083, 0x183, 0x283});
    bench.serve();
    for (const std::uint32_t mailbox : {0U, 1U, 2U}) {
        ASSERT_TRUE(bench.model.transmit());
        bench.record.clear();
        bench.serve();
        // RQCP0, RQCP1, RQCP2 of CAN_TSR: bits 0, 8, 16. A written 1 clears also TXOK.
        EXPECT_THAT(bench.record.writes(), ElementsAre(Pair(at_tsr, 1U << (8U * mailbox))));
    }
}

TEST(CanRegisters, AbortOfAFrameOnTheBusIsRequestedOnce) {
    verifies<req::CO_CAN_012>();
    RecordedCan bench;
    bench.join();
    bench.queue_up({0x083, 0x703});
    bench.serve();
    ASSERT_TRUE(bench.model.transmit());
    ASSERT_EQ(bench.model.begin_transmission()->id, 0x703U);  // from mailbox 1
    bench.queue_up({0x183, 0x283, 0x383});                    // 383h finds no mailbox
    for (int pass = 0; pass < 3; ++pass) {
        bench.serve();
    }
    // RQCP0 of the sent 083h, then ABRQ1 (bit 15)
    EXPECT_THAT(bench.record.writes_to(at_tsr), ElementsAre(1, 0x8000));
    bench.model.end_transmission(false);
    bench.serve();
    EXPECT_EQ(bench.model.registers().transmit[1].identifier.read(), (0x383U << 21U) | 1U);
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(CanRegisters, FrameThatStaysInItsMailboxIsRequestedOnceInACall) {
    verifies<req::CO_CAN_013>();
    RecordedCan bench;
    bench.join();
    for (const std::uint32_t id : {0x583U, 0x183U, 0x083U}) {
        bench.queue_up({id});
        bench.serve();
    }
    bench.queue_up({0x183});  // must stay behind 183h of mailbox 1, so 583h does not leave mailbox 0 for it
    while (bench.queue.size() < TransmitQueue::capacity) {
        bench.queue_up({0x703});
    }
    bench.record.clear();
    bench.serve();
    EXPECT_THAT(bench.record.writes_to(at_tsr), ElementsAre(0x80, 1));  // ABRQ0, then RQCP0
    EXPECT_EQ(bench.record.writes_to(at_ti0r).back(), (0x583U << 21U) | 1U);
    EXPECT_EQ(bench.record.writes().size(), 7U);
}

TEST(CanRegisters, DrainOfOneFrameReadsEachRegisterOnce) {
    verifies<req::CO_CAN_004>();
    RecordedCan bench;
    bench.join();
    bench.model.receive(data_frame(0x203, 8));
    bench.can.drain();
    // The state of both FIFOs is read before the frame and once more behind it. The frame has four registers.
    EXPECT_EQ(bench.record.reads_of(at_rf0r), 2U);
    EXPECT_EQ(bench.record.reads_of(at_rf1r), 2U);
    for (const std::size_t part : {0U, 4U, 8U, 12U}) {
        EXPECT_EQ(bench.record.reads_of(at_ri0r + part), 1U);
    }
    EXPECT_THAT(bench.record.writes(), ElementsAre(Pair(at_rf0r, 0x20)));  // RFOM
    EXPECT_EQ(bench.record.reads(), 8U);
}

TEST(CanRegisters, DrainEndsOnABusThatFillsTheFifosAgain) {
    verifies<req::CO_CAN_004>();
    RecordedCan bench;
    bench.join();
    bench.model.on_release = [&bench] { bench.model.receive(data_frame(0x203, 0)); };
    bench.model.receive(data_frame(0x203, 0));
    bench.can.drain();
    // An interrupt takes twice what the two FIFOs of three frames hold; the next interrupt takes the rest.
    EXPECT_EQ(bench.record.writes_to(at_rf0r).size(), 12U);
    EXPECT_EQ(bench.model.pending(0), 1U);
}

TEST(CanRegisters, OverrunFlagIsClearedOnlyWhereItWasSeen) {
    verifies<req::CO_CAN_005>();
    for (const std::uint32_t fifo : {0U, 1U}) {
        RecordedCan bench;
        bench.join();
        for (std::uint32_t i = 0; i <= fifo_depth; ++i) {
            bench.model.receive(data_frame(fifo == 0 ? 0x200 : 0x600, 0));
        }
        bench.can.drain();
        // FOVR is bit 4, and RFOM bit 5 of each of the three frames. FULL (bit 3) is not cleared. A flag that is set
        // between the read and the write of the other register must stay set.
        EXPECT_THAT(bench.record.writes_to(fifo == 0 ? at_rf0r : at_rf1r), ElementsAre(0x10, 0x20, 0x20, 0x20));
        EXPECT_THAT(bench.record.writes_to(fifo == 0 ? at_rf1r : at_rf0r), Each(0));
    }
}

}  // namespace canproof::test
