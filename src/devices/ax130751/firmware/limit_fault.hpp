// A fault with hysteresis: a measured value beyond its limit (AX130751, 1.8).
#pragma once

namespace canproof::ax130751 {

class LimitFault {
  public:
    /// Begins when the value is `beyond` its limit and ends when it has `recovered` by the hysteresis, or detection
    /// goes off.
    constexpr bool advance(const bool enabled, const bool beyond, const bool recovered) noexcept {
        if (!enabled) {
            present_ = false;
        } else if (beyond) {
            present_ = true;
        } else if (recovered) {
            present_ = false;
        } else {
            // within the hysteresis: as before
        }
        return present_;
    }
    constexpr bool is_present() const noexcept { return present_; }

  private:
    bool present_{false};
};

}  // namespace canproof::ax130751
