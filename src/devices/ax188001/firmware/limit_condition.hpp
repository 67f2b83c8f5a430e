// SPDX-License-Identifier: Apache-2.0
// Limits of a measured temperature or voltage, with one threshold that sets a fault and one that clears it.
#pragma once

#include "devices/ax188001/firmware/delayed_fault.hpp"

namespace canproof::ax188001 {

/// Evaluates an upper limit: the fault is set above `set` or for NaN, and cleared at or below `clear`. `set` is at
/// least `clear`.
constexpr FaultCondition high_limit(const double value, const double set, const double clear) noexcept {
    return FaultCondition{!(value <= set), value <= clear};
}

/// Evaluates a lower limit: the fault is set below `set` and cleared at or above `clear`. `set` is at most `clear`.
constexpr FaultCondition low_limit(const double value, const double set, const double clear) noexcept {
    return FaultCondition{value < set, value >= clear};
}

}  // namespace canproof::ax188001
