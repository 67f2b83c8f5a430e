// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int late(const bool set) {
    int value;  // flagged
    value = set ? 1 : 2;
    return value;
}
