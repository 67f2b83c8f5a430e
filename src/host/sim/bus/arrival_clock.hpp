// SPDX-License-Identifier: Apache-2.0
// Times of arrival on the clock of a run, from the kernel's time stamps. A process that loses the processor reads data
// late; its own clock, read before or after, gives a wrong time of arrival.
#pragma once

#include <cstdint>
#include <functional>

#include "firmware/base/time.hpp"

namespace canproof::host {

class ArrivalClock {
  public:
    using Clock = std::function<Instant()>;

    /// A larger difference means that the real time was set.
    static constexpr Duration tolerance = milliseconds(50);

    /// Sets the clock of the run. Without it, time stands still while the bus reads.
    void use(Clock clock) { clock_ = std::move(clock); }
    /// Compares the clock of the run with the real time, whose present value `realtime_ns` returns. `now` is the time
    /// of the run without a clock.
    void compare(Instant now, const std::function<std::uint64_t()>& realtime_ns);
    /// Returns a time stamp of CLOCK_REALTIME on the clock of the run; `otherwise` for 0, which is no time stamp, and
    /// for a time before the run.
    Instant at(std::uint64_t stamp_ns, Instant otherwise) const;
    /// The same for data that were just read in poll(now): without a clock of the run they arrived at `now`.
    Instant of_read(std::uint64_t stamp_ns, Instant now) const { return clock_ ? at(stamp_ns, clock_()) : now; }

  private:
    Clock clock_;
    bool is_known_{false};
    std::int64_t offset_us_{0};  ///< run time minus real time
    std::uint64_t error_us_{0};  ///< of offset_us_, at most
};

}  // namespace canproof::host
