// SPDX-License-Identifier: Apache-2.0
// A fault that is reported only after it has lasted for a delay, and that is cleared at once when it ends (AX188001,
// 3.4.16 and 3.4.21).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax188001 {

/// The result of a measurement. Between the two thresholds a value neither begins nor ends a fault.
struct FaultCondition {
    bool begins{false};  ///< beyond the threshold that sets the fault
    bool ends{true};     ///< at or past the threshold that clears the fault
};

class DelayedFault {
  public:
    /// Evaluates a new measurement. `delay` is the time that the fault must last before it is reported; the end of a
    /// fault has no delay.
    void judge(const FaultCondition& condition, const Duration delay, const Instant now) noexcept {
        if (told_) {
            told_ = !condition.ends;
        } else if (!condition.begins) {
            since_ = never;
        } else {
            since_ = earliest(since_, now);
            advance(delay, now);
        }
    }
    /// Turns a waiting fault into a reported fault when its delay has passed.
    void advance(const Duration delay, const Instant now) noexcept {
        if (due(delay) <= now) {
            told_ = true;
            since_ = never;
        }
    }
    /// Drops a fault that was not reported yet.
    void drop() noexcept { since_ = never; }
    /// Clears the fault, reported or waiting.
    void clear() noexcept {
        told_ = false;
        since_ = never;
    }

    bool told() const noexcept { return told_; }
    /// Returns the time at which the waiting fault will be reported; never when no fault waits.
    Instant due(const Duration delay) const noexcept { return since_ + delay; }

  private:
    Instant since_{never};
    bool told_{false};
};

}  // namespace canproof::ax188001
