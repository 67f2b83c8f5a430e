// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdlib>
void drop(int* const place) {
    delete place;  // flagged
}
void drop_too(int* const place) {
    std::free(place);  // flagged
}
