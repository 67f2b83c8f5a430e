// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <ctime>
const char* stale(const std::time_t one) {
    const char* const first = std::ctime(&one);  // flagged
    return first;
}
