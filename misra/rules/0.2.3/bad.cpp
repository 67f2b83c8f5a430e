// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int count(const int value) {
    using Count = int;  // flagged
    return value;
}
