// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int spare(const int value) {
    const int used{3};
    return value + used;
}
