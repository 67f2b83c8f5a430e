// SPDX-License-Identifier: Apache-2.0
// The last steps of the analogue output block (AX130751, 1.3): target, ramp and range. They get values that the scaling
// has already converted to the unit of the output type; all values here are in this unit.
#pragma once

#include <cmath>

#include "devices/ax130751/firmware/output_priority.hpp"
#include "devices/ax130751/firmware/ramp.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

/// The range of values of an output. 0 is OFF and always allowed.
struct OutputRange {
    double minimum{0.0};
    double maximum{0.0};

    /// Returns the nearest value in the range. If the range begins above 0, values at or below 0 give OFF. NaN gives
    /// OFF.
    static_assert(implements<req::AOR_OUT_016> && implements<req::AOR_OUT_034>);
    double nearest(const double value) const noexcept {
        const bool off = (minimum > 0.0) && (value <= 0.0);
        if (off || std::isnan(value)) {
            return 0.0;
        }
        if (value < minimum) {
            return minimum;
        }
        return (value > maximum) ? maximum : value;
    }
};

/// The values that the control signal, the override and the fault response ask for. The OutputDrive decides which of
/// them the output takes.
struct AnalogueDemand {
    double control{0.0};
    double override_value{0.0};
    double fault_value{0.0};
};

struct AnalogueOutputState {
    double target{0.0};  ///< before the ramp: 7330h output field value
    double value{0.0};   ///< after ramp and range; 2370h (feedback) shows what reaches the terminals
};

class AnalogueOutput {
  public:
    /// Returns target and value at `now`. `drive` says which of the values in `demand` the output takes, or that it is
    /// switched off or stays as it is. Only OutputDrive::control and ramp_off change the value by a ramp;
    /// OutputDrive::keep stops a ramp.
    AnalogueOutputState advance(OutputDrive drive, const AnalogueDemand& demand, const OutputRange& range,
                                const RampTimes& times, Instant now) noexcept;
    /// Switches the output OFF at once.
    void reset() noexcept { ramp_.set(0.0); }
    /// Returns whether a ramp is in progress.
    bool is_moving(const Instant now) const noexcept { return ramp_.is_moving(now); }

  private:
    Ramp ramp_{};
};

}  // namespace canproof::ax130751
