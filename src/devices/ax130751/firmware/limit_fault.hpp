// SPDX-License-Identifier: Apache-2.0
// A fault with hysteresis: a measured value beyond its limit (AX130751, 1.8).
#pragma once

namespace canproof::ax130751 {

class LimitFault {
  public:
    /// Updates the fault. It begins when the value is `beyond` its limit. It ends when the value has `recovered`
    /// (is back inside the limit by the hysteresis), or when detection is not `enabled`.
    constexpr bool advance(const bool enabled, const bool beyond, const bool recovered) noexcept {
        if (!enabled) {
            present_ = false;
        } else if (beyond) {
            present_ = true;
        } else if (recovered) {
            present_ = false;
        } else {
            // within the hysteresis the state stays
        }
        return present_;
    }
    constexpr bool is_present() const noexcept { return present_; }

  private:
    bool present_{false};
};

}  // namespace canproof::ax130751
