// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int one(const int value, const int other) {  // flagged
    return value;
}
