// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int again(int value) {
back:
    ++value;
    if (value < 9) {
        goto back;  // flagged
    }
    return value;
}
