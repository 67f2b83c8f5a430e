// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int limit(int value) {
    if (value > 3) {
        value = 3;
    } else if (value < 0) {
        value = 0;
    } else {
        value += 1;
    }
    return value;
}
