// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int again(int value) {
back:
    ++value;
    if (value < 9) {
        goto back;  // flagged
    }
    return value;
}
