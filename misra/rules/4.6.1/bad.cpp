// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int twice(int value) {
    return value + value++;  // flagged
}
