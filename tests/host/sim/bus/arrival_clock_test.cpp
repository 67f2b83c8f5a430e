// SPDX-License-Identifier: Apache-2.0
// Conversion of the kernel's time stamps to the clock of a run, also when the process is suspended between the readings
// of two clocks.
#include "host/sim/bus/arrival_clock.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace canproof::host::test {

namespace {

constexpr std::uint64_t ns = 1000;  // 1 µs in nanoseconds

/// A clock that first returns the times given, and then the last of them.
ArrivalClock::Clock clock_of(std::deque<std::uint64_t> times_us) {
    return [times = std::move(times_us)]() mutable {
        const Instant now{times.front()};
        if (times.size() > 1) {
            times.pop_front();
        }
        return now;
    };
}

ArrivalClock compared(std::deque<std::uint64_t> times_us, std::uint64_t real_us) {
    ArrivalClock clock;
    clock.use(clock_of(std::move(times_us)));
    clock.compare(Instant{}, [real_us] { return real_us * ns; });
    return clock;
}

}  // namespace

TEST(ArrivalClock, KernelTimestampIsConvertedToTheTimeOfTheRun) {
    const ArrivalClock clock = compared({1000}, 5000000);
    EXPECT_EQ(clock.at(5000250 * ns, Instant{7}), Instant{1250});
    EXPECT_EQ(clock.at(4999500 * ns, Instant{7}), Instant{500});
}

TEST(ArrivalClock, MissingTimestampAndTimestampBeforeTheRunAreReplacedByTheGivenTime) {
    const ArrivalClock clock = compared({1000}, 5000000);
    EXPECT_EQ(clock.at(0, Instant{7}), Instant{7});
    EXPECT_EQ(clock.at(4998999 * ns, Instant{7}), Instant{7});
}

TEST(ArrivalClock, ClockComparisonInterruptedForLongIsRepeated) {
    // The process loses the processor for 114 ms between its clock and the real time, then compares again.
    const ArrivalClock clock = compared({1000, 115000, 115000, 115000}, 5114000);
    EXPECT_EQ(clock.at(5100000 * ns, Instant{}), Instant{101000});
}

TEST(ArrivalClock, ClocksAreComparedUpToFourTimes) {
    // Three comparisons take 20 ms each, the fourth takes no time: 60 ms of the run are 5 s of the real time.
    const ArrivalClock fourth = compared({0, 20000, 20000, 40000, 40000, 60000, 60000, 60000}, 5000000);
    EXPECT_EQ(fourth.at(5000000 * ns, Instant{}), Instant{60000});
    // Four comparisons take 20 ms each, and there is no fifth. The first is as good as the others; its middle is 10 ms.
    const ArrivalClock fifth = compared({0, 20000, 20000, 40000, 40000, 60000, 60000, 80000, 80000, 80000}, 5000000);
    EXPECT_EQ(fifth.at(5000000 * ns, Instant{}), Instant{10000});
}

TEST(ArrivalClock, ClocksAreComparedAgainWhenAComparisonTakesLongerThan10Microseconds) {
    const ArrivalClock ten = compared({0, 10, 100, 100}, 5000000);
    // the real time was read between 0 and 10 us of the run, which counts as 5 us
    EXPECT_EQ(ten.at(5000000 * ns, Instant{}), Instant{5});
    const ArrivalClock eleven = compared({0, 11, 100, 100}, 5000000);
    // the first comparison takes 11 us, so a second one follows, which takes no time
    EXPECT_EQ(eleven.at(5000000 * ns, Instant{}), Instant{100});
}

TEST(ArrivalClock, MissingTimestampIsRecognisedWhenTheRunIsAheadOfTheRealTime) {
    const ArrivalClock clock = compared({1000}, 500);
    EXPECT_EQ(clock.at(0, Instant{7}), Instant{7});
    EXPECT_EQ(clock.at(1, Instant{7}), Instant{500});  // 1 ns is 0 us of the real time
}

TEST(ArrivalClock, MoreExactClockComparisonReplacesALessExactOne) {
    // Each comparison of the first call takes 20 ms: the offset is known within 10 ms.
    ArrivalClock clock = compared({0, 20000, 40000, 60000, 80000, 100000, 120000, 140000}, 5000000);
    EXPECT_EQ(clock.at(5000000 * ns, Instant{}), Instant{10000});
    clock.use(clock_of({200000}));
    clock.compare(Instant{}, [] { return 5195000 * ns; });
    EXPECT_EQ(clock.at(5195000 * ns, Instant{}), Instant{200000});
}

TEST(ArrivalClock, ClockComparisonThatIsNoMoreExactChangesNothingWithinTheTolerance) {
    ArrivalClock clock = compared({0, 20000, 40000, 60000, 80000, 100000, 120000, 140000}, 5000000);
    // Again each comparison takes 20 ms. The middle of the first is 110 ms of the run, 5 ms more than before.
    clock.use(clock_of({100000, 120000, 140000, 160000, 180000, 200000, 220000, 240000}));
    clock.compare(Instant{}, [] { return 5095000 * ns; });
    EXPECT_EQ(clock.at(5000000 * ns, Instant{}), Instant{10000});
    // Now the offset differs by 40 ms; the tolerance is 50 ms plus the time that the comparison takes.
    clock.use(clock_of({100000, 120000, 140000, 160000, 180000, 200000, 220000, 240000}));
    clock.compare(Instant{}, [] { return 5060000 * ns; });
    EXPECT_EQ(clock.at(5000000 * ns, Instant{}), Instant{10000});
}

TEST(ArrivalClock, ChangeOfTheRealTimeClockAboveTheToleranceIsFollowed) {
    ArrivalClock clock = compared({1000}, 5000000);
    clock.use(clock_of({2000}));
    clock.compare(Instant{}, [] { return 5051000 * ns; });  // 51 ms in 1 ms of the run: 50 ms are tolerated
    EXPECT_EQ(clock.at(5000000 * ns, Instant{}), Instant{1000});
    clock.compare(Instant{}, [] { return 5051001 * ns; });
    EXPECT_EQ(clock.at(5051001 * ns, Instant{}), Instant{2000});
}

TEST(ArrivalClock, ArrivalTimeIsTheReadTimeWhenTheRunHasNoClock) {
    ArrivalClock clock;
    clock.compare(Instant{1000}, [] { return 5000000 * ns; });
    EXPECT_EQ(clock.of_read(4999900 * ns, Instant{1000}), Instant{1000});
    clock.use(clock_of({3000}));
    EXPECT_EQ(clock.of_read(4999900 * ns, Instant{1000}), Instant{900});
    EXPECT_EQ(clock.of_read(0, Instant{1000}), Instant{3000});
}

}  // namespace canproof::host::test
