// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int past() {
    const int row[3] = {1, 2, 3};
    return row[4];  // flagged
}
