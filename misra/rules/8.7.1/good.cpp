// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int last() {
    const int row[3] = {1, 2, 3};
    return row[2];
}
