// Any signal read as ON or OFF (AX130751, 1.2, Figure 1).
#pragma once

#include "devices/ax130751/firmware/block_signal.hpp"

namespace canproof::ax130751 {

/// OFF at or below the signal's lower limit, ON at or above its upper one, and as before in between. Where the limits
/// coincide the signal is OFF at them.
class DigitalReading {
  public:
    /// A signal in error leaves the state as it was; one that is not available is OFF.
    constexpr bool read(const BlockSignal& signal) noexcept {
        if (!signal.is_available()) {
            on_ = false;
        } else if (signal.is_valid()) {
            if (signal.value <= signal.lower) {
                on_ = false;
            } else if (signal.value >= signal.upper) {
                on_ = true;
            } else {
                // within the hysteresis
            }
        } else {
            // in error
        }
        return on_;
    }
    constexpr bool on() const noexcept { return on_; }

  private:
    bool on_{false};
};

}  // namespace canproof::ax130751
