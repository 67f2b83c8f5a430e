// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int limit(int value) {
    if (value > 3) {  // flagged
        value = 3;
    } else if (value < 0) {
        value = 0;
    }
    return value;
}
