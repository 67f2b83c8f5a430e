// What a fuzz target demands of every execution.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace canproof::fuzz {

/// Ends the run as a finding, and says where, when it does not hold.
inline void require(bool holds, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    if (!holds) {
        std::fprintf(stderr, "requirement violated at %s:%d\n", file, line);
        std::abort();
    }
}

}  // namespace canproof::fuzz
