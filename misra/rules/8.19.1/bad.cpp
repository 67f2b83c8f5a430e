// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int both(int one, const int other) {
    return one += 2, one + other;  // flagged
}
