// SPDX-License-Identifier: Apache-2.0
// A state that follows the wanted state after separate delays for ON and OFF (AX130751, 22A1h on delay, 22A2h off
// delay).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

class DelayedState {
  public:
    /// Follows the wanted state and returns the present one. If the wanted state changes back before its delay has
    /// passed, the change is cancelled; the next change starts a new delay.
    bool follow(const bool wanted, const Duration on_delay, const Duration off_delay, const Instant now) noexcept {
        if (wanted == state_) {
            pending_ = false;
            return state_;
        }
        if (!pending_) {
            pending_ = true;
            since_ = now;
        }
        due_ = since_ + (wanted ? on_delay : off_delay);
        if (due_ <= now) {
            set(wanted);
        }
        return state_;
    }
    /// Sets the state at once and cancels a pending change.
    void set(const bool state) noexcept {
        state_ = state;
        pending_ = false;
    }
    /// Returns when the pending change is due; never when there is none.
    Instant due() const noexcept { return pending_ ? due_ : never; }

    /// Returns whether `state` is the present state (properties/invariants).
    bool is(bool state) const noexcept;

  private:
    bool state_{false};
    bool pending_{false};
    Instant since_{};
    Instant due_{never};
};

}  // namespace canproof::ax130751
