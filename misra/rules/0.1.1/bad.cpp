// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int lost(const int value) {
    int copy = value;  // flagged
    copy = 4;          // flagged
    return value;
}
