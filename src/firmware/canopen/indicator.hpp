// SPDX-License-Identifier: Apache-2.0
// Computes when an LED is lit (CAN-CBX-AO412, 3.2.1; after CiA 303-3).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof {

/// One period of an indicator: `flashes` times on with gaps between them, then a pause. With no flashes the LED is
/// steadily lit when `on` is not 0, otherwise dark.
struct IndicatorPattern {
    std::uint16_t flashes{0U};
    Duration on{};
    Duration gap{};
    Duration pause{};

    constexpr bool is_steady() const noexcept { return flashes == 0U; }
    /// Returns the period of a pattern that is not steady. After the last flash the pause replaces the gap.
    constexpr Duration period() const noexcept { return Duration{((flashes * (on.us + gap.us)) - gap.us) + pause.us}; }
};

struct IndicatorPhase {
    bool lit{false};
    Instant next_change{never};
};

/// Returns whether the LED is lit at `now`, and when that changes next: at the end of the present flash, gap or pause,
/// or never for a steady pattern. All LEDs count their periods from time 0 plus `shift`, so LEDs of the same pattern
/// and shift flash together.
IndicatorPhase indicator_phase(const IndicatorPattern& pattern, Instant now, Duration shift) noexcept;

}  // namespace canproof
