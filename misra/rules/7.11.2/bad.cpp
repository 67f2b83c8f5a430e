// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int total(const int* row);
int use() {
    const int row[3] = {1, 2, 3};
    return total(row);  // flagged
}
