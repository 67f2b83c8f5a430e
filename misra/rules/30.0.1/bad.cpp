// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdio>  // flagged
int tell() {
    return std::puts("x");  // flagged
}
