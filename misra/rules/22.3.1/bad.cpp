// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cassert>
void check() {
    assert(sizeof(int) == 4U);  // flagged
}
