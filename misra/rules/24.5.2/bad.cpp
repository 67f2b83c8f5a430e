// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstring>
void copy(int& to, const int& from) {
    static_cast<void>(std::memcpy(&to, &from, sizeof to));  // flagged
}
