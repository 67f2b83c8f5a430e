// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int sum(int value) {
    for (; value < 3; ++value) {  // flagged
    }
    for (int i = 1; i < 64; i *= 2) {  // flagged
        value += i;
    }
    return value;
}
