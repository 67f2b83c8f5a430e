// SPDX-License-Identifier: Apache-2.0
// Lets environment variables say how often a fuzz target does its expensive checks (Samples in beside_hook.hpp).
#pragma once

#include <algorithm>
#include <cstdlib>

namespace canproof::fuzz {

/// Lets an environment variable, if it is set, say how many inputs get one more check.
inline void read_sample(const char* variable, unsigned& one_in) {
    if (const char* const text = std::getenv(variable)) {
        one_in = static_cast<unsigned>(std::max(1, std::atoi(text)));
    }
}

}  // namespace canproof::fuzz
