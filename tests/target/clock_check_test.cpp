// SPDX-License-Identifier: Apache-2.0
// Tests what the check of the clock writes to TIM5, as values of RM0090 18.4, and the limits at which it reports a
// failure.
#include "target/stm32f405/selftest/clock_check.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/capture_model.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/register_record.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

// Offsets of the registers: RM0090 18.4.21.
constexpr std::size_t at_cr1 = 0x00, at_sr = 0x10, at_egr = 0x14, at_ccmr2 = 0x1C, at_ccer = 0x20, at_psc = 0x28,
                      at_arr = 0x2C, at_ccr4 = 0x40, at_or = 0x50;
constexpr std::uint32_t cc4if = 1U << 4U, cc4of = 1U << 12U;

/// A check at 80 MHz on registers without side effects, which the test sets.
struct PlainClockCheck {
    PlainModel<CaptureRegisters> model;
    RegisterRecord record;
    ClockCheck check{model.registers(), 80};
    Instant now{5000000};

    PlainClockCheck() {
        record.watch(model.registers());
        check.start(now);
    }
    /// Returns the result of a step that sees a capture at this count of the timer.
    bool step_at(std::uint32_t count, std::uint32_t flags = cc4if) {
        model.at(at_sr) = flags;
        model.at(at_ccr4) = count;
        now.us += 250;
        record.clear();
        return check.step(now);
    }
    bool step_after(std::uint64_t us) {
        model.at(at_sr) = 0;
        now.us += us;
        return check.step(now);
    }
};

}  // namespace

TEST(ClockCheckRegisters, TimerCountsEachClockAndCapturesEachEighthEdge) {
    verifies<req::CO_SELF_006>();
    CaptureModel model;
    RegisterRecord record;
    record.watch(model.registers());
    ClockCheck check{model.registers(), 80};
    check.start(Instant{});
    EXPECT_THAT(record.writes_to(at_or), ElementsAre(0x40));  // TI4_RMP 01: the low-speed oscillator
    EXPECT_THAT(record.writes_to(at_psc), ElementsAre(0));    // each clock
    EXPECT_THAT(record.writes_to(at_arr), ElementsAre(0xFFFFFFFF));
    EXPECT_THAT(record.writes_to(at_egr), ElementsAre(1));        // UG
    EXPECT_THAT(record.writes_to(at_ccmr2), ElementsAre(0xD00));  // IC4PSC 11 (bits 11, 10), CC4S 01 (bits 9, 8)
    EXPECT_THAT(record.writes_to(at_ccer), ElementsAre(0x1000));  // CC4E
    EXPECT_THAT(record.writes_to(at_cr1), ElementsAre(1));        // CEN
    const auto writes = record.writes();
    ASSERT_EQ(writes.size(), 7U);
    // An update event loads the prescaler (18.4.11). The model reports a fault when CC4S is written behind CC4E.
    EXPECT_LT(std::find(writes.begin(), writes.end(), RegisterRecord::One(at_psc, 0)),
              std::find(writes.begin(), writes.end(), RegisterRecord::One(at_egr, 1)));
    EXPECT_THAT(model.faults(), IsEmpty());
}

TEST(ClockCheckRegisters, IntervalAtItsLimitsIsAcceptedAndOneCountBeyondIsNot) {
    verifies<req::CO_SELF_006>();
    // 170 and 471 µs are 13,600 and 37,680 counts at 80 MHz. The counter wraps between the two captures.
    constexpr std::uint32_t first = 0xFFFFF000;
    for (const auto& [counts, accepted] : {std::pair(13599U, false), {13600U, true}, {37680U, true}, {37681U, false}}) {
        PlainClockCheck bench;
        EXPECT_TRUE(bench.step_at(first));
        EXPECT_EQ(bench.step_at(first + counts), accepted) << counts;
    }
}

TEST(ClockCheckRegisters, OnlyTheFlagOfAMissedCaptureIsCleared) {
    verifies<req::CO_SELF_006>();
    PlainClockCheck bench;
    EXPECT_TRUE(bench.step_at(1000));
    EXPECT_THAT(bench.record.writes(), IsEmpty());
    EXPECT_TRUE(bench.step_at(2000, cc4if | cc4of));  // 1000 counts are not judged: a capture was missed
    EXPECT_THAT(bench.record.writes(), ElementsAre(Pair(at_sr, ~cc4of)));
}

TEST(ClockCheckRegisters, NoCaptureFor100MillisecondsIsAFailure) {
    verifies<req::CO_SELF_015>();
    PlainClockCheck bench;  // started at 5 s
    EXPECT_TRUE(bench.step_after(99999));
    EXPECT_FALSE(bench.step_after(1));
    EXPECT_TRUE(bench.step_at(1000));
    EXPECT_TRUE(bench.step_after(99999));
    EXPECT_FALSE(bench.step_after(1));
}

TEST(ClockCheckRegisters, FirstCaptureAfterARestartIsNotCompared) {
    verifies<req::CO_SELF_006>();
    PlainClockCheck bench;
    EXPECT_TRUE(bench.step_at(1000));
    bench.check.start(bench.now);
    EXPECT_TRUE(bench.step_at(900000));
    EXPECT_FALSE(bench.step_at(900001));
}

}  // namespace canproof::test
