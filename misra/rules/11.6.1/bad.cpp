// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int late(const bool set) {
    int value;  // flagged
    value = set ? 1 : 2;
    return value;
}
