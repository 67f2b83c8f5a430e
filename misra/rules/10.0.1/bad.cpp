// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int sum() {
    int one = 1, two = 2;  // flagged
    return one + two;
}
