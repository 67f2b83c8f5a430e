// SPDX-License-Identifier: Apache-2.0
// The load of a bus over the last second.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace canproof::host {

/// Counts busy periods. Times are in nanoseconds of virtual time.
class BusLoad {
  public:
    static constexpr std::uint64_t window = 1000000000;

    /// Adds a busy period from `start` to `end`. Forgets the periods that ended more than a second before `start`, so
    /// the periods must be added in ascending order. The time in which two periods overlap counts twice.
    void add(std::uint64_t start, std::uint64_t end) {
        busy_.push_back({start, end});
        while (busy_.front().end + window < start) {
            busy_.pop_front();
        }
    }
    /// Returns the load over the second before `now`, or over the time since 0 if that is shorter; 1 is a bus that is
    /// always busy. `running_since` is the start of the present transmission; without a transmission it must be `now`.
    double at(std::uint64_t now, std::uint64_t running_since) const {
        const std::uint64_t length = std::min(now, window);
        const std::uint64_t begin = now - length;
        std::uint64_t used = now - std::clamp(running_since, begin, now);
        for (const Span& one : busy_) {
            used += std::clamp(one.end, begin, now) - std::clamp(one.start, begin, now);
        }
        return length == 0 ? 0.0 : static_cast<double>(used) / static_cast<double>(length);
    }
    /// Returns the number of periods that are kept.
    std::size_t kept() const { return busy_.size(); }

  private:
    struct Span {
        std::uint64_t start;
        std::uint64_t end;
    };

    std::deque<Span> busy_;
};

}  // namespace canproof::host
