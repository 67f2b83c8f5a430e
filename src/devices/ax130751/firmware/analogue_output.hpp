// The analogue output block behind its scaling (AX130751, 1.3): target, ramp and range. Values in the unit of the type.
#pragma once

#include "devices/ax130751/firmware/output_priority.hpp"
#include "devices/ax130751/firmware/ramp.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

/// What an output can be driven to. 0 is OFF and always allowed.
struct OutputRange {
    double minimum{0.0};
    double maximum{0.0};

    /// The nearest value in the range; at or below 0 where the range begins above it, OFF.
    static_assert(implements<req::AOR_OUT_016>);
    constexpr double nearest(const double value) const noexcept {
        const bool off = (minimum > 0.0) && (value <= 0.0);
        if (off) {
            return 0.0;
        }
        if (value < minimum) {
            return minimum;
        }
        return (value > maximum) ? maximum : value;
    }
};

/// The values that are asked for; which of them counts is the drive's choice.
struct AnalogueDemand {
    double control{0.0};
    double override_value{0.0};
    double fault_value{0.0};
};

struct AnalogueOutputState {
    double target{0.0};  ///< before the ramp: 7330h
    double value{0.0};   ///< what drives the output: 2370h
};

class AnalogueOutput {
  public:
    AnalogueOutputState advance(OutputDrive drive, const AnalogueDemand& demand, const OutputRange& range,
                                const RampTimes& times, Instant now) noexcept;
    /// OFF, at once.
    void reset() noexcept { ramp_.set(0.0); }
    /// Whether a ramp is under way.
    bool is_moving(const Instant now) const noexcept { return ramp_.is_moving(now); }

  private:
    Ramp ramp_{};
};

}  // namespace canproof::ax130751
