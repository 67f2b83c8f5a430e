// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int sign(const int value) {
    if (value > 0) {
        return 1;
    }
}  // flagged
