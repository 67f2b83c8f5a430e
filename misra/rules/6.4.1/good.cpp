// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int outer(const int value) {
    int sum{value};
    for (int i = 0; i < 3; ++i) {
        sum += i;
    }
    return sum;
}
