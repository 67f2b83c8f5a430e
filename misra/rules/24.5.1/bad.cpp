// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cctype>
bool digit(const int letter) {
    return std::isdigit(letter) != 0;  // flagged
}
