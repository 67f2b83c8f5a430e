// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int first(const int value) {
    return value;
    return value + 1;  // flagged
}
