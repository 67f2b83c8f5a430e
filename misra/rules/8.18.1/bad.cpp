// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstring>
void shift(char* const text) {
    static_cast<void>(std::memcpy(text + 1, text, 4));  // flagged
}
union Both {
    int whole;
    short half[2];
};
short low(const Both both) {
    return both.half[0];  // flagged
}
