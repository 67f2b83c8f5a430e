// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int first(const int value) {
    return value;
    return value + 1;  // flagged
}
