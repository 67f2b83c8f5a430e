// Virtual time of a session, which never goes back: what was due before now is done now.
#pragma once

#include "firmware/base/time.hpp"

namespace canproof::host {

class ForwardTime {
  public:
    Instant now() const { return now_; }
    /// Now, once what is due at `due` is done.
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
