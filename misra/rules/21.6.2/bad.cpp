// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstdlib>
void drop(int* const place) {
    delete place;  // flagged
}
void drop_too(int* const place) {
    std::free(place);  // flagged
}
