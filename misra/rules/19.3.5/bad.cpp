// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define SAME(value) value
int now() {
    return SAME(
#define INNER 3  // flagged
        3);
}
