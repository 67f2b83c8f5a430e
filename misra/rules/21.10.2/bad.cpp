// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <csetjmp>  // flagged
void leave(std::jmp_buf place) {  // flagged
    std::longjmp(place, 1);       // flagged
}
