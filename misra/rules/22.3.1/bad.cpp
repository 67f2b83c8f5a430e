// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cassert>
void check() {
    assert(sizeof(int) == 4U);  // flagged
}
