// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int limit(const int value) {
    if (value > 3)  // flagged
        return 3;
    return value;
}
