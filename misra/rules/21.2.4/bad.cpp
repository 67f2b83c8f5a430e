// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstddef>
struct Row {
    int one;
    int two;
};
std::size_t place() {
    return offsetof(Row, two);  // flagged
}
