// The digital output block (AX130751, 1.2).
#pragma once

#include "devices/ax130751/firmware/output_priority.hpp"
#include "devices/ax130751/firmware/switch_polarity.hpp"
#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

/// The states that are asked for; which of them counts is the drive's choice.
struct DigitalDemand {
    bool control{false};
    bool override_state{false};
    bool fault_state{false};
};

struct DigitalOutputState {
    bool logic{false};  ///< 7330h
    bool drive{false};  ///< 2370h
};

class DigitalOutput {
  public:
    DigitalOutputState advance(OutputDrive drive, const DigitalDemand& demand, const SwitchPolarity& polarity,
                               Duration blink, Instant now) noexcept;
    /// OFF, at once, and nothing remembered.
    void reset() noexcept { *this = DigitalOutput{}; }
    /// When it will change by itself, its inputs staying as they are.
    Instant next_change() const noexcept { return next_blink_; }

  private:
    bool follow_control(SwitchDrive drive, Duration blink, Instant now) noexcept;

    DigitalOutputState state_{};
    bool control_before_{false};
    bool memory_{false};  ///< of latched logic: kept while something else drives the output
    bool blinking_{false};
    Instant blinking_since_{};
    Instant next_blink_{never};
};

}  // namespace canproof::ax130751
