// SPDX-License-Identifier: Apache-2.0
// The virtual time of a session. It never decreases: an overdue event happens at the present time.
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::host {

class ForwardTime {
  public:
    Instant now() const { return now_; }
    /// Sets the time to `due` if `due` is later. Returns the time of the session.
    Instant reach(Instant due) {
        if (now_ < due) {
            now_ = due;
        }
        return now_;
    }

  private:
    Instant now_{};
};

}  // namespace canproof::host
