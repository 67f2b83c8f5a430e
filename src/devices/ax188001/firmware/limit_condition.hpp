// Limits of a measured temperature or voltage, with a threshold for setting and one for clearing.
#pragma once

#include "devices/ax188001/firmware/delayed_fault.hpp"

namespace canproof::ax188001 {

/// A fault above `set`, cleared at `clear` or below it. `set` is not less than `clear`.
constexpr FaultCondition high_limit(const double value, const double set, const double clear) noexcept {
    return FaultCondition{value > set, value <= clear};
}

/// A fault below `set`, cleared at `clear` or above it. `set` is not more than `clear`.
constexpr FaultCondition low_limit(const double value, const double set, const double clear) noexcept {
    return FaultCondition{value < set, value >= clear};
}

}  // namespace canproof::ax188001
