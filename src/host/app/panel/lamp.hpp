// SPDX-License-Identifier: Apache-2.0
// Describes an LED in the words of CiA 303-3, from the times at which it went on and off.
#pragma once

#include <deque>
#include <string>

#include "firmware/base/time.hpp"
#include "firmware/canopen/indicator.hpp"
#include "firmware/canopen/vocabulary.hpp"

namespace canproof::host {

struct LampEdge {
    Instant time{};
    bool lit{false};
};

/// The newest changes of one LED from dark to lit and from lit to dark.
class LampHistory {
  public:
    /// Records the state at `now`. Returns whether it differs from the previous state; before the first call, the LED
    /// is dark.
    bool show(bool lit, Instant now);
    bool lit() const { return !edges_.empty() && edges_.back().lit; }
    /// Returns the pattern: `off`, `on`, `blinking`, `flickering`, or `1 flash` … `4 flashes`. Before the second flash,
    /// returns the present state, `off` or `on`. After it, returns `flashing` until the changes are enough to tell the
    /// pattern.
    std::string words(Instant now) const;

  private:
    // number of changes: two groups of four flashes, and one incomplete group
    static constexpr std::size_t edges_kept = 24;

    std::deque<LampEdge> edges_;
};

/// Returns the pattern of the green run LED by CiA 303-3 for an NMT state.
IndicatorPattern run_lamp(NmtState state);

}  // namespace canproof::host
