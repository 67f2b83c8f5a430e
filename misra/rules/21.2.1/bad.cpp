// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdlib>
int read(const char* const text) {
    return std::atoi(text);  // flagged
}
