// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int work();
using Work = int (*)();
Work choose() {
    return work;  // flagged
}
