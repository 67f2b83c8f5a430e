// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
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
