// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/arrival_clock.hpp"

#include <cstdlib>
#include <utility>

namespace canproof::host {

namespace {

constexpr int most_comparisons = 4;
constexpr std::uint64_t good_enough_us = 10;

}  // namespace

void ArrivalClock::use(Clock clock) {
    clock_ = std::move(clock);
}

/// Reads the real time between two readings of the run's clock. If these readings are far apart, the process did not
/// run in between, so the comparison is repeated. The comparison with the shortest distance is used. It replaces an
/// earlier result if it is more exact, or if the real time was set.
void ArrivalClock::compare(Instant now, const std::function<std::uint64_t()>& realtime_ns) {
    std::uint64_t best = UINT64_MAX;
    std::int64_t offset = 0;
    for (int i = 0; i < most_comparisons && best > good_enough_us; ++i) {
        const Instant before = clock_ ? clock_() : now;
        const auto real_us = static_cast<std::int64_t>(realtime_ns() / 1000U);
        const Instant after = clock_ ? clock_() : now;
        if (elapsed(before, after).us < best) {
            best = elapsed(before, after).us;
            offset = static_cast<std::int64_t>(before.us + best / 2U) - real_us;
        }
    }
    const auto change = static_cast<std::uint64_t>(std::abs(offset - offset_us_));
    if (!is_known_ || best < error_us_ || change > tolerance.us + best) {
        offset_us_ = offset;
        error_us_ = best;
        is_known_ = true;
    }
}

Instant ArrivalClock::at(std::uint64_t stamp_ns, Instant otherwise) const {
    const std::int64_t us = static_cast<std::int64_t>(stamp_ns / 1000U) + offset_us_;
    const bool is_stamped = stamp_ns != 0U && us >= 0;
    return is_stamped ? Instant{static_cast<std::uint64_t>(us)} : otherwise;
}

}  // namespace canproof::host
