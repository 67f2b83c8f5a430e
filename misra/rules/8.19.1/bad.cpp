// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int both(int one, const int other) {
    return one += 2, one + other;  // flagged
}
