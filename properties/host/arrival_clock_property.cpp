// SPDX-License-Identifier: Apache-2.0
// Checks the class that converts real times of arrival to times of the run. A naive clock, which searches a list of all
// comparisons of both clocks, must give the same times.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/sim/bus/arrival_clock.hpp"

namespace canproof::host {

namespace {

/// One comparison of two clocks: the real time is read between two readings of the clock of the run. All times are in
/// µs.
struct Reading {
    std::int64_t before{0};
    std::int64_t after{0};
    std::int64_t real{0};

    std::int64_t distance() const { return after - before; }
    std::int64_t offset() const { return before + distance() / 2 - real; }
};

/// Returns up to four comparisons. One whose two readings are at most 10 us apart is exact enough and is the last.
std::vector<Reading> any_readings(std::int64_t& run, std::int64_t& real) {
    std::vector<Reading> readings;
    while (readings.size() < 4U && (readings.empty() || readings.back().distance() > 10)) {
        Reading one;
        one.before = run;
        const auto first = *rc::gen::element<std::int64_t>(0, 4, 5, 30, 100);
        const auto last = *rc::gen::element<std::int64_t>(0, 5, 6, 30, 3000);
        one.after = run + first + last;
        one.real = real + first;
        readings.push_back(one);
        run += first + last;
        real += first + last;
    }
    return readings;
}

}  // namespace

RC_GTEST_PROP(ArrivalClockLaw, ClockOffsetIsThatOfTheMostExactComparisonSinceTheTimeWasSet, ()) {
    std::int64_t run = 1000000;
    std::int64_t real = 1700000000000000;
    std::vector<Reading> readings;
    std::size_t next = 0;
    bool is_after = false;
    ArrivalClock clock;
    clock.use([&] {
        const std::int64_t us = is_after ? readings[next].after : readings[next].before;
        next += is_after ? 1U : 0U;
        is_after = !is_after;
        return Instant{static_cast<std::uint64_t>(us)};
    });
    Reading kept{0, 0, 0};
    bool is_known = false;
    for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
        run += 1000000;
        real += 1000000 + *rc::gen::element<std::int64_t>(0, 0, 1, -20, 900, 49990, 50000, 50006, 50040, -60000);
        readings = any_readings(run, real);
        next = 0;
        clock.compare(Instant{}, [&] { return static_cast<std::uint64_t>(readings[next].real) * 1000U + 999U; });
        RC_ASSERT(next == readings.size());
        const Reading best =
            *std::min_element(readings.begin(), readings.end(),
                              [](const Reading& a, const Reading& b) { return a.distance() < b.distance(); });
        const std::int64_t change = std::max(best.offset() - kept.offset(), kept.offset() - best.offset());
        // a drift of 50 ms is tolerated, in addition to the error of this comparison
        if (!is_known || best.distance() < kept.distance() || change > 50000 + best.distance()) {
            kept = best;
            is_known = true;
        }
        const std::int64_t expected = real + kept.offset();
        RC_ASSERT(clock.at(static_cast<std::uint64_t>(real) * 1000U, never) ==
                  (expected < 0 ? never : Instant{static_cast<std::uint64_t>(expected)}));
        RC_ASSERT(clock.at(0U, Instant{7}) == Instant{7});
        const std::int64_t early = -kept.offset() - 1;  // 1 us before time 0 of the run
        RC_ASSERT(clock.at(static_cast<std::uint64_t>(early) * 1000U, Instant{7}) == Instant{7});
    }
}

}  // namespace canproof::host
