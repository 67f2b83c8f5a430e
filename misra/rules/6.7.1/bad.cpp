// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int next() {
    static int count{0};  // flagged
    ++count;
    return count;
}
