// A value that moves towards its target no faster than told (AX130751, 1.3, 2330h and 2331h).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

/// `span` is passed in `up` when rising and in `down` when falling. A time or a span of 0 steps.
struct RampTimes {
    double span{0.0};
    Duration up{};
    Duration down{};
};

/// Calculated from where and when the last change of target or times found it: how often it is asked does not matter.
class Ramp {
  public:
    /// Stands at `value` from now on.
    void set(double value) noexcept;
    /// Moves towards `target`; gives where it stands at `now`.
    double follow(double target, const RampTimes& times, Instant now) noexcept;
    /// Stops where it stands at `now`.
    double hold(Instant now) noexcept;

    double value_at(Instant now) const noexcept;
    /// Whether it is not yet at its target.
    bool is_moving(Instant now) const noexcept;

  private:
    // A way begins at `start_` at `since_`. Keys: the target and all three times; another one begins a new way.
    double start_{0.0};
    double target_{0.0};
    Instant since_{};
    RampTimes times_{};
};

}  // namespace canproof::ax130751
