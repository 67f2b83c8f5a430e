// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
void chain(int& one, int& other) {
    other = 3;
    one = other;
}
