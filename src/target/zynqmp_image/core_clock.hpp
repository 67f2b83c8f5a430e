// SPDX-License-Identifier: Apache-2.0
// The time of a Cortex-A53: its virtual timer (Arm DDI 0487, G6), which also wakes the core from sleep.
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::target {

class CoreClock {
  public:
    /// Lets the timer's interrupt end the sleep of the core. No handler runs, because interrupts stay masked.
    void start();
    /// Returns the microseconds since start().
    Instant now() const;
    /// Sleeps until now() is `until` or later.
    void sleep(Instant until) const;

  private:
    std::uint64_t begin_{0U};
    std::uint64_t ticks_a_second_{1U};
};

}  // namespace canproof::target
