// How a run keeps up with the clock: everything due, but no longer than a turn at a time, so that the run goes on
// hearing its user. Tells how far the simulation is behind.
#pragma once

#include <functional>
#include <string>

#include "host/sim/run/run_session.hpp"

namespace canproof::host {

class Pace {
  public:
    using Clock = std::function<Instant()>;
    /// Real time that one turn may take.
    static constexpr Duration turn = milliseconds(50);
    /// A lag from which on it is told.
    static constexpr Duration worth_telling = milliseconds(500);
    static constexpr Duration telling_period = milliseconds(10000);

    /// `clock` gives real time as the session counts it; `notice` gets what the user should know.
    Pace(Clock clock, NoticeListener notice) : clock_{std::move(clock)}, notice_{std::move(notice)} {}

    /// Moves the session on to `until`, or as far as one turn goes.
    void advance(RunSession& session, Instant until);
    /// How far the session stayed behind the clock in the last turn; 0 when it did all that was due.
    Duration lag() const { return lag_; }
    /// "the simulation was up to 1.2 s behind the bus"; empty when it was never worth telling.
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
