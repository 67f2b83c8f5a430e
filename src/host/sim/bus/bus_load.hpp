// SPDX-License-Identifier: Apache-2.0
// The load of a bus over the last second.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>

namespace canproof::host {

/// Counts busy periods. Times are in nanoseconds of virtual time.
class BusLoad {
  public:
    static constexpr std::uint64_t window = 1000000000;

    /// Adds a busy period from `start` to `end`. Periods must be added in ascending order and must not overlap.
    void add(std::uint64_t start, std::uint64_t end) { busy_.push_back({start, end}); }
    /// Removes the periods that ended more than a second before `now`.
    void forget_before(std::uint64_t now) {
        while (!busy_.empty() && busy_.front().end + window < now) {
            busy_.pop_front();
        }
    }
    /// Returns the load, 0 to 1, over the second before `now`, or over the time since 0 if that is shorter.
    /// `running_since` is the start of the present transmission; without a transmission it must be `now`.
    double at(std::uint64_t now, std::uint64_t running_since) const {
        const std::uint64_t length = std::min(now, window);
        const std::uint64_t begin = now - length;
        std::uint64_t used = running_since < now ? now - std::max(running_since, begin) : 0;
        for (const Span& one : busy_) {
            const std::uint64_t from = std::max(one.start, begin);
            const std::uint64_t to = std::min(one.end, now);
            used += to > from ? to - from : 0;
        }
        return length == 0 ? 0.0 : static_cast<double>(used) / static_cast<double>(length);
    }

  private:
    struct Span {
        std::uint64_t start;
        std::uint64_t end;
    };

    std::deque<Span> busy_;
};

}  // namespace canproof::host
