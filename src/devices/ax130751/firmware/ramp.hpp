// SPDX-License-Identifier: Apache-2.0
// A value that moves towards its target with a limited slope (AX130751, 1.3, 2330h ramp up, 2331h ramp down).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

/// Slopes of a ramp: the value covers `span` in the time `up` when rising and `down` when falling. With a time or a
/// span of 0 the value jumps.
struct RampTimes {
    double span{0.0};
    Duration up{};
    Duration down{};
};

/// A ramp. Each value is computed from the value and the time at the last change of the target or of the slopes, so the
/// rate of the calls does not matter.
class Ramp {
  public:
    /// Sets the value at once and ends a ramp.
    void set(double value) noexcept;
    /// Moves towards `target`; returns the value at `now`.
    double follow(double target, const RampTimes& times, Instant now) noexcept;
    /// Ends the ramp at the value that it has at `now`, and returns this value.
    double hold(Instant now) noexcept;

    double value_at(Instant now) const noexcept;
    /// Returns whether the value has not reached its target.
    bool is_moving(Instant now) const noexcept;

  private:
    // The present ramp began with `start_` at `since_`. A change of the target, of the span or of one of the two times
    // begins a new ramp.
    double start_{0.0};
    double target_{0.0};
    Instant since_{};
    RampTimes times_{};
};

}  // namespace canproof::ax130751
