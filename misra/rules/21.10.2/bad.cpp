// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <csetjmp>  // flagged
void leave(std::jmp_buf place) {  // flagged
    std::longjmp(place, 1);       // flagged
}
