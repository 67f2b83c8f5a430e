// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <new>
int* place(void* const room) {
    return new (room) int(3);  // flagged
}
struct Row {
    void* operator new(std::size_t size);  // flagged
};
