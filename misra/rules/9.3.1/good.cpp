// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int limit(const int value) {
    if (value > 3) {
        return 3;
    }
    return value;
}
