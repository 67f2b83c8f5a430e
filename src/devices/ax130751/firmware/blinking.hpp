// ON and OFF by turns (AX130751, 1.2 and 1.4).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::ax130751 {

/// Begins with ON at `since` and changes every `half_period`; 0 stays ON.
constexpr bool blinks_on(const Instant since, const Duration half_period, const Instant now) noexcept {
    return (half_period.us == 0U) || (((elapsed(since, now).us / half_period.us) % 2U) == 0U);
}

/// The next change after `now`.
constexpr Instant next_blink(const Instant since, const Duration half_period, const Instant now) noexcept {
    return (half_period.us == 0U)
               ? never
               : (since + Duration{((elapsed(since, now).us / half_period.us) + 1U) * half_period.us});
}

}  // namespace canproof::ax130751
