// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int sign(const int value) {
    if (value > 0) {
        return 1;
    }
}  // flagged
