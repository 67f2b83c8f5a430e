// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/indicator.hpp"

namespace canproof {

IndicatorPhase indicator_phase(const IndicatorPattern& pattern, const Instant now, const Duration shift) noexcept {
    const std::uint64_t period = pattern.period().us;
    if (pattern.is_steady() || (period == 0U)) {
        return IndicatorPhase{pattern.on.us != 0U, never};
    }
    // The position is the time since the pattern's period began. Adding one period keeps the difference from getting
    // negative.
    const std::uint64_t position = ((now.us + period) - (shift.us % period)) % period;
    std::uint64_t edge{0U};
    for (std::uint32_t flash = 0U; flash < pattern.flashes; ++flash) {
        edge += pattern.on.us;
        if (position < edge) {
            return IndicatorPhase{true, now + Duration{edge - position}};
        }
        const bool last = (flash + 1U) == pattern.flashes;
        edge += pattern.gap.us;
        if ((!last) && (position < edge)) {
            return IndicatorPhase{false, now + Duration{edge - position}};
        }
    }
    // the pause
    return IndicatorPhase{false, now + Duration{period - position}};
}

}  // namespace canproof
