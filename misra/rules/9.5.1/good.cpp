// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int sum(int value) {
    for (int i = 0; i < 3; ++i) {
        value += i;
    }
    return value;
}
