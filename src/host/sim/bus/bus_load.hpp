// How busy a bus has been over the last second.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>

namespace canproof::host {

/// Times are in nanoseconds of virtual time.
class BusLoad {
  public:
    static constexpr std::uint64_t window = 1000000000;

    /// The bus was busy from `start` to `end`; one after another.
    void add(std::uint64_t start, std::uint64_t end) { busy_.push_back({start, end}); }
    /// What ended more than a second before `now` counts no more.
    void forget_before(std::uint64_t now) {
        while (!busy_.empty() && busy_.front().end + window < now) {
            busy_.pop_front();
        }
    }
    /// 0…1, over the second before `now` or the time since 0 when that is shorter. `running_since`: the start of a
    /// frame that is on the wire still; `now` when there is none.
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
