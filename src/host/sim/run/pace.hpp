// SPDX-License-Identifier: Apache-2.0
// Keeps a run in step with the clock. It advances the session for a limited time per turn, so that the run stays
// responsive, and reports how late the simulation is.
#pragma once

#include <functional>
#include <string>

#include "host/sim/run/run_session.hpp"

namespace canproof::host {

class Pace {
  public:
    using Clock = std::function<Instant()>;
    /// Longest real time of one turn.
    static constexpr Duration turn = milliseconds(50);
    /// Lag from which on it is reported.
    static constexpr Duration worth_telling = milliseconds(500);
    static constexpr Duration telling_period = milliseconds(10000);

    /// `clock` returns real time relative to the start of the session; `notice` receives messages for the user.
    Pace(Clock clock, NoticeListener notice) : clock_{std::move(clock)}, notice_{std::move(notice)} {}

    /// Advances the session to `until`, or as far as possible in one turn.
    void advance(RunSession& session, Instant until);
    /// Returns the lag of the session after the last turn; 0 when it handled all due events.
    Duration lag() const { return lag_; }
    /// Returns "the simulation was up to 1.2 s behind the bus"; empty when the lag was never reported.
    std::string summary() const;

  private:
    void tell(Instant now);

    Clock clock_;
    NoticeListener notice_;
    Duration lag_{};
    Duration worst_{};
    Instant tell_from_{};
    bool told_{false};
};

}  // namespace canproof::host
