// A fault that is told only when it has lasted for a while (AX188001, 3.4.16 and 3.4.21), and cleared at once.
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax188001 {

/// What the last measurement says. Between its two thresholds a value neither begins a fault nor ends one.
struct FaultCondition {
    bool begins{false};  ///< beyond the threshold that sets the fault
    bool ends{true};     ///< beyond the threshold that clears it
};

class DelayedFault {
  public:
    /// A new measurement. `delay` is how long the fault must last before it is told.
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
    /// Tells a fault whose delay has passed.
    void advance(const Duration delay, const Instant now) noexcept {
        if (due(delay) <= now) {
            told_ = true;
            since_ = never;
        }
    }
    /// Forgets a fault that was not told yet.
    void drop() noexcept { since_ = never; }
    /// No fault, none waiting.
    void clear() noexcept {
        told_ = false;
        since_ = never;
    }

    bool told() const noexcept { return told_; }
    /// When the fault that waits is told; never when none does.
    Instant due(const Duration delay) const noexcept { return since_ + delay; }

  private:
    Instant since_{never};
    bool told_{false};
};

}  // namespace canproof::ax188001
