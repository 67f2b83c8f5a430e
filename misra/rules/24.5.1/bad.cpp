// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cctype>
bool digit(const int letter) {
    return std::isdigit(letter) != 0;  // flagged
}
