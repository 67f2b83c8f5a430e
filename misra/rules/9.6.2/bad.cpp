// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int enter(const int value) {
    if (value > 3) {
        goto inside;  // flagged
    }
    if (value < 0) {
    inside:
        return 1;
    }
    return 0;
}
