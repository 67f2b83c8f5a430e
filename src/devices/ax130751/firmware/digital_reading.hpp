// SPDX-License-Identifier: Apache-2.0
// Reads any signal as ON or OFF (AX130751, 1.2, Figure 1).
#pragma once

#include "devices/ax130751/firmware/block_signal.hpp"

namespace canproof::ax130751 {

/// The state of a signal: OFF at or below its lower limit, ON at or above its upper limit, unchanged between them. If
/// the limits coincide, the signal is OFF at that value.
class DigitalReading {
  public:
    /// Reads a signal and returns the state. A signal in error keeps the state; one that is not available is OFF.
    constexpr bool read(const BlockSignal& signal) noexcept {
        if (!signal.is_available()) {
            on_ = false;
        } else if (signal.is_valid()) {
            if (signal.value <= signal.lower) {
                on_ = false;
            } else if (signal.value >= signal.upper) {
                on_ = true;
            } else {
                // between the limits the state stays
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
