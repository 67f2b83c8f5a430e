// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int past() {
    const int row[3] = {1, 2, 3};
    return row[4];  // flagged
}
