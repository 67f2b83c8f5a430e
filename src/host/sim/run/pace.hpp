// SPDX-License-Identifier: Apache-2.0
// Keeps a run in step with the clock. It advances the session for a limited time in each turn, so that the program can
// react to input. It reports the delay of the simulation.
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
    /// Least delay of the simulation that is reported.
    static constexpr Duration worth_telling = milliseconds(500);
    static constexpr Duration telling_period = milliseconds(10000);

    /// Prepares the pace. `clock` returns the real time since the start of the session. `notice` receives messages for
    /// the user.
    Pace(Clock clock, NoticeListener notice) : clock_{std::move(clock)}, notice_{std::move(notice)} {}

    /// Advances the session to `until`, but works for at most `turn` of real time.
    void advance(RunSession& session, Instant until);
    /// Returns how far the session is behind the real time after the last turn; 0 when it has handled all due events.
    Duration lag() const { return lag_; }
    /// Returns a sentence such as "the simulation was up to 1.2 s behind the bus"; empty when no delay was reported.
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
