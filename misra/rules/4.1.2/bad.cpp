// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <stdint.h>  // flagged
[[deprecated]] int old_way();
int now() {
    return old_way();  // flagged
}
