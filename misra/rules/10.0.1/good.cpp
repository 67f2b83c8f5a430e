// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int sum() {
    int one = 1;
    int two = 2;
    return one + two;
}
