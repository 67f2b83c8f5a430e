// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int one(const int value, const int other) {  // flagged
    return value;
}
