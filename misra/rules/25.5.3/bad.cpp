// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <ctime>
const char* stale(const std::time_t one) {
    const char* const first = std::ctime(&one);  // flagged
    return first;
}
