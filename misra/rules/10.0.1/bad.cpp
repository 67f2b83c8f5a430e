// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int sum() {
    int one = 1, two = 2;  // flagged
    return one + two;
}
