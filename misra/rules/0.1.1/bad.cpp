// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int lost(const int value) {
    int copy = value;  // flagged
    copy = 4;          // flagged
    return value;
}
