// SPDX-License-Identifier: Apache-2.0
// The record of a failed self-test over a reset, and what a device reports from it.
#include "target/stm32f405/selftest/failure_record.hpp"

#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;

}  // namespace

TEST(FailureRecord, RecordReturnsTheFailedSelfTestOnce) {
    verifies<req::CO_SELF_009>();
    PlainModel<FailureWords> words;
    FailureRecord record{words.registers()};
    for (const SelfTest test : {SelfTest::core, SelfTest::stack, SelfTest::clock, SelfTest::ram, SelfTest::flash,
                                SelfTest::outputs, SelfTest::flow, SelfTest::state}) {
        record.keep(test);
        EXPECT_EQ(record.take(), test);
        EXPECT_EQ(record.take(), SelfTest::none);
    }
}

TEST(FailureRecord, ArbitraryMemoryContentIsNotTakenForARecord) {
    verifies<req::CO_SELF_009>();
    PlainModel<FailureWords> words;
    FailureRecord record{words.registers()};
    for (const std::uint32_t content : {0U, 0xFFFFFFFFU, 0x12345678U}) {
        words.at(0) = content;
        words.at(4) = ~content;
        EXPECT_EQ(record.take(), SelfTest::none);
    }
    for (std::size_t at : {0U, 4U}) {
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            record.keep(SelfTest::ram);
            words.at(at) ^= 1U << bit;
            EXPECT_EQ(record.take(), SelfTest::none);
        }
    }
}

// CO-D-SELF-001: a device reports failed hardware or failed software after the record of a test, whatever the cause of
// the reset, and failed software after a reset by the watchdog without a record.
TEST(FailureRecord, StartReportsFailedHardwareOrSoftware) {
    verifies<req::CO_D_SELF_001, req::CO_SELF_016>();
    struct Row {
        SelfTest failed;
        bool by_watchdog, has_crystal, software, hardware;
    };
    for (const Row& row : {Row{SelfTest::none, false, true, false, false},
                           {SelfTest::none, true, true, true, false},
                           {SelfTest::none, false, false, false, true},
                           {SelfTest::none, true, false, true, true},
                           {SelfTest::ram, true, true, false, true},
                           {SelfTest::ram, false, true, false, true},
                           {SelfTest::core, true, true, false, true},
                           {SelfTest::clock, true, false, false, true},
                           {SelfTest::flash, true, true, false, true},
                           {SelfTest::stack, true, true, true, false},
                           {SelfTest::stack, false, true, true, false},
                           {SelfTest::outputs, false, true, true, false},
                           {SelfTest::flow, true, true, true, false},
                           {SelfTest::state, true, false, true, true}}) {
        SCOPED_TRACE(static_cast<int>(row.failed));
        const StartFaults faults = faults_at_start(row.failed, row.by_watchdog, row.has_crystal);
        EXPECT_EQ(faults.software, row.software);
        EXPECT_EQ(faults.hardware, row.hardware);
    }
}

TEST(FailureRecord, CoreClockRamAndFlashTestsFindFailedHardware) {
    verifies<req::CO_D_SELF_001, req::CO_SELF_016>();
    for (const SelfTest test : {SelfTest::core, SelfTest::clock, SelfTest::ram, SelfTest::flash}) {
        EXPECT_TRUE(finds_hardware(test));
    }
    for (const SelfTest test : {SelfTest::none, SelfTest::stack, SelfTest::outputs, SelfTest::flow, SelfTest::state}) {
        EXPECT_FALSE(finds_hardware(test));
    }
}

}  // namespace canproof::test
