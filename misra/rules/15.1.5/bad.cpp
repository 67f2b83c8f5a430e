// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <initializer_list>
struct Row {
    Row(std::initializer_list<int> cells);  // flagged
    explicit Row(int size);
};
