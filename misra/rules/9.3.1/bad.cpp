// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int limit(const int value) {
    if (value > 3)  // flagged
        return 3;
    return value;
}
