// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#define SAME(value) value
int now() {
    return SAME(
#define INNER 3  // flagged
        3);
}
