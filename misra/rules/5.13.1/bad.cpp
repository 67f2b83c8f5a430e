// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
const char* path() {
    return "a\qb";  // flagged
}
