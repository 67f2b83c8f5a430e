// SPDX-License-Identifier: Apache-2.0
// The digital output block (AX130751, 1.2).
#pragma once

#include "devices/ax130751/firmware/output_priority.hpp"
#include "devices/ax130751/firmware/switch_polarity.hpp"
#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

/// The states that the control signal, the override and the fault response ask for. The OutputDrive decides which of
/// them the output takes.
struct DigitalDemand {
    bool control{false};
    bool override_state{false};
    bool fault_state{false};
    bool is_valid{true};  ///< the control signal has a value and is not in error
};

struct DigitalOutputState {
    bool logic{false};  ///< 7330h output field value
    bool drive{false};  ///< 2370h feedback field value
};

class DigitalOutput {
  public:
    /// Returns the states at `now`. `drive` says which of the states in `demand` the output takes, or that it is
    /// switched off or stays as it is. The polarity applies to OutputDrive::control only. Call advance() in every
    /// cycle: it detects edges of the control signal between two calls.
    DigitalOutputState advance(OutputDrive drive, const DigitalDemand& demand, const SwitchPolarity& polarity,
                               Duration blink, Instant now) noexcept;
    /// Switches OFF at once and clears all states.
    void reset() noexcept { *this = DigitalOutput{}; }
    /// Returns when the output changes by itself with constant inputs.
    Instant next_change() const noexcept { return next_blink_; }

  private:
    bool follow_control(SwitchDrive drive, Duration blink, Instant now) noexcept;

    DigitalOutputState state_{};
    bool control_before_{false};
    bool was_valid_{true};
    bool memory_{false};  ///< state of a latched output; unchanged while the control signal does not drive the output
    bool blinking_{false};
    Instant blinking_since_{};
    Instant next_blink_{never};
};

}  // namespace canproof::ax130751
