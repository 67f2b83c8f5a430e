// SPDX-License-Identifier: Apache-2.0
// Blinking: a state that alternates between ON and OFF (AX130751, 1.2 and 1.4).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

/// Returns the state of a blinking output: it begins with ON at `since` and changes every `half_period`. With a
/// `half_period` of 0 it stays ON.
constexpr bool blinks_on(const Instant since, const Duration half_period, const Instant now) noexcept {
    return (half_period.us == 0U) || (((elapsed(since, now).us / half_period.us) % 2U) == 0U);
}

/// Returns the time of the next change after `now`; never when `half_period` is 0.
constexpr Instant next_blink(const Instant since, const Duration half_period, const Instant now) noexcept {
    return (half_period.us == 0U)
               ? never
               : (since + Duration{((elapsed(since, now).us / half_period.us) + 1U) * half_period.us});
}

}  // namespace canproof::ax130751
