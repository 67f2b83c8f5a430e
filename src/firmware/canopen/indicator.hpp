// When an LED is lit (CAN-CBX-AO412, 3.2.1; after CiA 303-3).
#pragma once

#include "firmware/base/time.hpp"

namespace canproof {

/// One round of an indicator: `flashes` times on with gaps between them, then a pause. Without flashes steadily lit
/// when `on` is not 0, else dark.
struct IndicatorPattern {
    std::uint16_t flashes{0U};
    Duration on{};
    Duration gap{};
    Duration pause{};

    constexpr bool is_steady() const noexcept { return flashes == 0U; }
    /// Of what is not steady: behind the last flash stands the pause in place of the gap.
    constexpr Duration period() const noexcept { return Duration{((flashes * (on.us + gap.us)) - gap.us) + pause.us}; }
};

struct IndicatorPhase {
    bool lit{false};
    Instant next_change{never};
};

/// Whether the LED is lit at `now`, and when that changes. All LEDs count their rounds from time 0 plus `shift`, so
/// that those of one pattern flash together and those shifted by one `on` time in opposite phase.
IndicatorPhase indicator_phase(const IndicatorPattern& pattern, Instant now, Duration shift) noexcept;

}  // namespace canproof
