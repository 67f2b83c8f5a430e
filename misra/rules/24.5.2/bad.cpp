// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstring>
void copy(int& to, const int& from) {
    static_cast<void>(std::memcpy(&to, &from, sizeof to));  // flagged
}
