// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int total(const int* row);
int use() {
    const int row[3] = {1, 2, 3};
    return total(row);  // flagged
}
