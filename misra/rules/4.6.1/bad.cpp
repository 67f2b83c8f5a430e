// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int twice(int value) {
    return value + value++;  // flagged
}
