// A state that follows what is wanted after a delay of its own for each way (AX130751, 22A1h and 22A2h).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

class DelayedState {
  public:
    /// A wish that goes away before its delay has passed is forgotten; the delay begins anew with the next.
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
    /// Takes a state at once and forgets what was pending.
    void set(const bool state) noexcept {
        state_ = state;
        pending_ = false;
    }
    /// When what is pending will be done; never when nothing is.
    Instant due() const noexcept { return pending_ ? due_ : never; }

  private:
    bool state_{false};
    bool pending_{false};
    Instant since_{};
    Instant due_{never};
};

}  // namespace canproof::ax130751
