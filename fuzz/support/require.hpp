// SPDX-License-Identifier: Apache-2.0
// Checks a condition that a fuzz target requires.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace canproof::fuzz {

/// When `holds` is false, prints the source line, the requirement `what`, and `number` in hexadecimal. Then ends the
/// run as a finding.
inline void require(bool holds, const char* what = "", unsigned long number = 0, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE()) {
    if (!holds) {
        std::fprintf(stderr, "requirement violated at %s:%d %s %lX\n", file, line, what, number);
        std::abort();
    }
}

}  // namespace canproof::fuzz
