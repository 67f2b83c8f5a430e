// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstring>
unsigned long length(const char* const text) {
    return std::strlen(text);  // flagged
}
