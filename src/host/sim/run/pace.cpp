// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/pace.hpp"

#include <fmt/format.h>

#include "host/base/time_text.hpp"

namespace canproof::host {

namespace {

double seconds_of(Duration time) {
    return static_cast<double>(time.us) / 1.0e6;
}

}  // namespace

void Pace::advance(RunSession& session, Instant until) {
    const Instant begin = clock_();
    session.advance_to(until, [&] { return elapsed(begin, clock_()).us < turn.us; });
    const Instant now = clock_();
    lag_ = session.now() < until ? elapsed(session.now(), now) : Duration{};
    worst_ = worst_.us < lag_.us ? lag_ : worst_;
    tell(now);
}

void Pace::tell(Instant now) {
    if (lag_.us >= worth_telling.us && tell_from_ <= now) {
        told_ = true;
        tell_from_ = now + telling_period;
        notice_(
            fmt::format("the simulation is {:.1f} s behind the bus: this machine is too slow or too busy; run fewer "
                        "devices, or end other programs",
                        seconds_of(lag_)));
    } else if (lag_.us == 0 && told_) {
        told_ = false;
        notice_("the simulation has caught up with the bus");
    }
}

std::string Pace::summary() const {
    return worst_.us < worth_telling.us
               ? ""
               : fmt::format("the simulation was up to {:.1f} s behind the bus", seconds_of(worst_));
}

}  // namespace canproof::host
