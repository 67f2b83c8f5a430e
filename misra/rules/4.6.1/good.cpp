// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int twice(int value) {
    const int before{value};
    ++value;
    return value + before;
}
