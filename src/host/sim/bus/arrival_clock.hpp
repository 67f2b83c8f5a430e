// SPDX-License-Identifier: Apache-2.0
// Converts the kernel's time stamps of received data to the clock of a run. The process can read data long after they
// have arrived, so its own clock does not give the time of arrival.
#pragma once

#include <cstdint>
#include <functional>

#include "firmware/base/time.hpp"

namespace canproof::host {

class ArrivalClock {
  public:
    using Clock = std::function<Instant()>;

    /// Largest difference between two comparisons; a larger one means that somebody has set the real time.
    static constexpr Duration tolerance = milliseconds(50);

    /// Sets the clock of the run. Without a clock, time does not advance while the bus reads.
    void use(Clock clock);
    /// Compares the clock of the run with the real time, which `realtime_ns` returns. Without a clock, `now` is the
    /// time of the run.
    void compare(Instant now, const std::function<std::uint64_t()>& realtime_ns);
    /// Converts a time stamp of CLOCK_REALTIME to the clock of the run. Returns `otherwise` for the value 0, which
    /// means no time stamp, and for a time before the run.
    Instant at(std::uint64_t stamp_ns, Instant otherwise) const;
    /// Returns the time of arrival of data that poll(now) has just read. It is the result of at(), or `now` without a
    /// clock of the run.
    Instant of_read(std::uint64_t stamp_ns, Instant now) const { return clock_ ? at(stamp_ns, clock_()) : now; }

  private:
    Clock clock_;
    bool is_known_{false};
    std::int64_t offset_us_{0};  ///< time of the run minus real time
    std::uint64_t error_us_{0};  ///< greatest error of offset_us_
};

}  // namespace canproof::host
