// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstddef>
struct Row {
    int one;
    int two;
};
std::size_t place() {
    return offsetof(Row, two);  // flagged
}
