// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstring>
unsigned long length(const char* const text) {
    return std::strlen(text);  // flagged
}
