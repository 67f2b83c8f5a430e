// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int next() {
    static int count{0};  // flagged
    ++count;
    return count;
}
