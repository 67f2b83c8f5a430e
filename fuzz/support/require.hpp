// What a fuzz target demands of every execution.
#pragma once

#include <cstdlib>

namespace canproof::fuzz {

/// Ends the run as a finding when it does not hold.
inline void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

}  // namespace canproof::fuzz
