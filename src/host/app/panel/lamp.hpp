// What an LED shows, told from when it went on and off: the words of CiA 303-3 for those who cannot watch it flash.
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

/// The newest edges of one LED.
class LampHistory {
  public:
    /// True when this is another state than before.
    bool show(bool lit, Instant now);
    bool lit() const { return !edges_.empty() && edges_.back().lit; }
    /// `off`, `on`, `blinking`, `flickering`, `1 flash` … `4 flashes`; `flashing` while there is too little to tell.
    std::string words(Instant now) const;

  private:
    static constexpr std::size_t edges_kept = 24;  // two rounds of four flashes, and one that was begun

    std::deque<LampEdge> edges_;
};

/// The green run LED of CiA 303-3 for a state.
IndicatorPattern run_lamp(NmtState state);

}  // namespace canproof::host
