// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <stdint.h>  // flagged
[[deprecated]] int old_way();
int now() {
    return old_way();  // flagged
}
